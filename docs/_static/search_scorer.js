// Order of search results: pages whose title or index entries hold the words of the question, pages for use first.
"use strict";
var Scorer = {
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 5, 1: 0, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,

  score(result) {
    const [page, title, , , score, , kind] = result;
    const places = [["how-to/", 6], ["tutorials/", 5], ["explanation/", 3], ["reference/api/", -4], ["reference/changelog", -20]];
    const place = (places.find(([start]) => page.startsWith(start)) || ["", 0])[1];
    if (kind === SearchResultKind.object) return score + place;
    if (kind === SearchResultKind.index) result[2] = ""; // the page, once, as a hit in its text
    const plain = (text) => text.toLowerCase().split(/[^\p{L}\p{N}]+/u).filter((word) => word.length > 1);
    const asked = plain(new URLSearchParams(window.location.search).get("q") || "").filter((word) => !Scorer.small.has(word));
    const said = plain(title + " " + (page.startsWith("reference/api/") ? "" : Scorer.entries(page)));
    const root = (word) => (word.length > 4 ? word.replace(/(e?s|ing|ed)$/, "") : word);
    const hits = asked.filter((word) => said.some((one) => root(one) === root(word) || (word.length > 3 && one.startsWith(word))));
    return Math.min(score, 20) + place + (asked.length ? (25 * hits.length) / asked.length : 0);
  },

  // Index entries of a page; those that Sphinx makes of documented names lie under reference/api.
  entries(page) {
    if (!Scorer.found) {
      Scorer.found = new Map();
      const { docnames, indexentries } = Search._index;
      for (const [entry, places] of Object.entries(indexentries))
        for (const [file] of places) Scorer.found.set(docnames[file], `${Scorer.found.get(docnames[file]) || ""} ${entry}`);
    }
    return Scorer.found.get(page) || "";
  },

  small: new Set(["an", "and", "at", "by", "can", "do", "does", "for", "from", "how", "in", "is", "it", "my", "of", "on", "or", "our", "the", "to", "what", "with", "write"]),
};
