"use strict";var jounce=(()=>{var Au=Object.defineProperty;var $v=Object.getOwnPropertyDescriptor;var Xv=Object.getOwnPropertyNames;var qv=Object.prototype.hasOwnProperty;var Yv=(i,e)=>{for(var t in e)Au(i,t,{get:e[t],enumerable:!0})},Zv=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of Xv(e))!qv.call(i,s)&&s!==t&&Au(i,s,{get:()=>e[s],enumerable:!(n=$v(e,s))||n.enumerable});return i};var Kv=i=>Zv(Au({},"__esModule",{value:!0}),i);var ST={};Yv(ST,{live:()=>Bf});var hp="jounce-language",Cu=localStorage.getItem(hp),up=Cu==="de"||Cu==="en"?Cu:navigator.language.startsWith("de")?"de":"en";document.documentElement.lang=up;function dp(){let i=document.createElement("button"),e=up==="de"?"en":"de";return i.type="button",i.className="language",i.lang=e,i.textContent=e==="de"?"Deutsch":"English",i.addEventListener("click",()=>{localStorage.setItem(hp,e),location.reload()}),i}var jv={light:"Light",dark:"Dark",showLight:"Show this page light",showDark:"Show this page dark",failed:"The interactive plots could not be made (#); the figures of this page show the same.",choice:"what is shown",previous:"previous ([)",next:"next (])",curves:"curves",channels:"channels",more:"# more",otherChannels:"all other channels",zoomIn:"zoom in (+)",zoomOut:"zoom out (−)",all:"All",everything:"everything (0, or double click)",event:"Event",zoomToEvent:"zoom to the event (9)",wide:"Full window",fillWindow:"fill the window (f)",play:"Play",pause:"Pause",speed:"speed",realTime:"real time",fast:"fast",hint:"Drag to zoom, double click for everything; Ctrl + wheel zooms, Shift + wheel pans. Keys: space plays, ← → step, + − 0 zoom, [ ] change what is shown, f fills the window.",view:"view",space:"3-D",front:"front",side:"side",top:"top",wheel:"wheel",names:"names",paths:"paths",mechanism:"The mechanism; drag to turn it, click on it to zoom with the wheel",noContact:"no contact",noWebGL:"The mechanism is drawn with WebGL, which this browser does not offer.",strut:"spring and damper",contactPoint:"contact point"},Jv={light:"Hell",dark:"Dunkel",showLight:"Seite hell darstellen",showDark:"Seite dunkel darstellen",failed:"Die interaktiven Diagramme konnten nicht erstellt werden (#); die Abbildungen der Seite zeigen dasselbe.",choice:"Auswahl",previous:"zurück ([)",next:"weiter (])",curves:"Kurven",channels:"Kanäle",more:"# weitere",otherChannels:"alle weiteren Kanäle",zoomIn:"vergrößern (+)",zoomOut:"verkleinern (−)",all:"Alles",everything:"gesamter Bereich (0 oder Doppelklick)",event:"Ereignis",zoomToEvent:"auf das Ereignis zoomen (9)",wide:"Großansicht",fillWindow:"ganzes Fenster nutzen (f)",play:"Abspielen",pause:"Pause",speed:"Tempo",realTime:"Echtzeit",fast:"schnell",hint:"Bereich aufziehen zum Zoomen, Doppelklick zeigt alles; Strg + Mausrad zoomt, Umschalt + Mausrad verschiebt. Tasten: Leertaste spielt ab, ← → Einzelschritt, + − 0 Zoom, [ ] wechselt die Auswahl, f Großansicht.",view:"Ansicht",space:"3-D",front:"vorn",side:"Seite",top:"oben",wheel:"Rad",names:"Namen",paths:"Bahnkurven",mechanism:"Die Radaufhängung; ziehen dreht sie, nach einem Klick zoomt das Mausrad",noContact:"kein Bodenkontakt",noWebGL:"Die Radaufhängung wird mit WebGL gezeichnet, das dieser Browser nicht anbietet.",strut:"Feder und Dämpfer",contactPoint:"Radaufstandspunkt"},ca=document.documentElement.lang.startsWith("de"),Qv=ca?Jv:jv;function St(i,e=""){return Qv[i].replace("#",()=>e)}function fi(i){let e=i.replaceAll("-","−");return ca?e.replace(".",","):e}var go={},Ru=null;function fp(i){Object.assign(go,i),Ru=null}function e_(i){if(Object.hasOwn(go,i))return go[i];if(!(i.length>400)){Ru??=Object.entries(go).filter(([e])=>e.includes("#")&&e.replaceAll("#","").trim().length>4).sort(([e],[t])=>t.length-e.length).map(([e,t])=>[new RegExp(`^${e.split("#").map(n=>n.replace(/[.*+?^${}()|[\]\\]/g,"\\$&")).join("(.+?)")}$`,"s"),t]);for(let[e,t]of Ru){let[,...n]=e.exec(i)??[];if(n.length)return t.replace(/#/g,()=>Vi(n.shift()??""))}}}function Vi(i){return ca&&/^[A-Z]|\s/.test(i)&&e_(i)||i}function F(i,e=""){return(ca&&go[i]||i).replace("#",()=>e)}fp({Project:"Projekt",Rig:"Fahrwerk",Trial:"Fahrversuch",Kinematics:"Kinematik",Records:"Messungen",Campaign:"Kampagne",Studies:"Studien",Jobs:"Aufträge",Ride:"Fahrkomfort",Inspection:"Prüfung","To the content":"Zum Inhalt","loading …":"lädt …","Back to the project":"Zurück zum Projekt",Pages:"Seiten","The server does not answer: start it again with jounce serve.":"Der Server antwortet nicht: mit jounce serve neu starten.","This page is not known here any more: open the address that jounce serve printed.":"Diese Seite ist hier nicht mehr bekannt: die Adresse öffnen, die jounce serve ausgegeben hat.",Search:"Suchen","Hardpoints that may move":"Kinematikpunkte, die sich bewegen dürfen","Each coordinate by up to":"Jede Koordinate um bis zu",Searches:"Suchläufe","Add a target above, and choose a hardpoint that may move.":"Oben ein Ziel hinzufügen und einen Punkt wählen, der sich bewegen darf.","share done":"erledigter Anteil",Cancel:"Abbrechen","# s left":"noch # s","The search was ended.":"Die Suche wurde beendet.","Take the best":"Besten übernehmen",Take:"Übernehmen","Take the design of search #":"Entwurf der Suche # übernehmen","Every target is met.":"Alle Ziele sind erreicht.","# of the targets are missed.":"# der Ziele sind verfehlt.",searches:"Suchläufe",search:"Suchlauf",targets:"Ziele","cost, tolerances²":"Kosten, Toleranzen²","moved, share of the boxes":"bewegt, Anteil der Grenzen",ended:"Ende",met:"erreicht",missed:"verfehlt","what was moved":"was bewegt wurde",number:"Größe",before:"vorher",after:"nachher",unit:"Einheit","Its report":"Bericht dazu","line #":"Zeile #","Add to #":"Zu # hinzufügen","the rig":"dem Fahrwerk","add …":"hinzufügen …","Take # away":"# entfernen","kind of #":"Art von #",typed:"als Zahl","first:last:step":"von:bis:Schritt","This rig has no hardpoints, and so no kinematics: ":"Dieses Fahrwerk hat keine Kinematikpunkte und daher keine Kinematik: ","choose another one":"ein anderes wählen","wheel travel":"Radhub","rack travel":"Zahnstangenweg","roll of the body":"Wanken des Aufbaus","Wheel travel, bump positive":"Radhub, Einfedern positiv","Rack travel, to the left positive":"Zahnstangenweg, nach links positiv","Roll, left side up positive":"Wanken, linke Seite hoch positiv","nothing else":"nichts weiter","earlier versions":"frühere Fassungen",replaced:"ersetzt","this project":"dieses Projekt",shipped:"mitgeliefert",centres:"Momentanpole","instant centres in front and side view, and the roll centre":"Momentanpole in Vorder- und Seitenansicht und das Wankzentrum",none:"keine","computing; the first time a model is compiled once, which takes some seconds":"rechnet; beim ersten Mal wird ein Modell einmal übersetzt, was einige Sekunden dauert",dashed:"gestrichelt","# curves computed and drawn":"# Kurven berechnet und gezeichnet",in:"in","computed and drawn in":"berechnet und gezeichnet in","camber, roll centre …":"camber, roll centre …","Write these changes into the file":"Diese Änderungen in die Datei schreiben","Nothing is changed.":"Nichts ist geändert.","The changes stand in the file; what it was before is an earlier version.":"Die Änderungen stehen in der Datei; ihr vorheriger Stand ist eine frühere Fassung.","Start a rig of your own from this one to design it.":"Zum Entwerfen ein eigenes Fahrwerk aus diesem anlegen.","Kinematics of #":"Kinematik von #","To its file":"Zu seiner Datei","Curves over":"Kurven über","Compare with":"Vergleichen mit","Targets of a study":"Ziele einer Studie","Show curves with":"Kurven zeigen mit",curves:"Kurven",Numbers:"Zahlen",Targets:"Ziele","Design from targets":"Entwurf aus Zielen",Quantity:"Größe","is wanted":"soll",Value:"Wert",Tolerance:"Toleranz","At, or over first:last:step":"Bei, oder über von:bis:Schritt","Add the target":"Ziel hinzufügen","at design":"in Konstruktionslage","None yet: add one below, and its band stands in its curve.":"Noch keine: unten eines hinzufügen, und sein Band steht in der Kurve.","within the tolerance":"innerhalb der Toleranz","outside of the tolerance":"außerhalb der Toleranz","not swept as far as this is wanted":"nicht so weit durchfahren, wie dies gewünscht ist","Copy it here":"Hierher kopieren","Shipped rig":"Mitgeliefertes Fahrwerk","Name of your file":"Name der eigenen Datei",files:"Dateien",file:"Datei","what it is":"was es ist",size:"Größe","written (UTC)":"geschrieben (UTC)","to do":"zu tun","No rigs, roads or records lie here yet. Start from a rig that comes with jounce, or put your files into the folder.":"Hier liegen noch keine Fahrwerke, Straßen oder Messungen. Mit einem mitgelieferten Fahrwerk beginnen oder eigene Dateien in den Ordner legen.","Start from an example":"Mit einem Beispiel beginnen","Runs that were kept":"Aufbewahrte Läufe","Start from a shipped rig, below.":"Unten mit einem mitgelieferten Fahrwerk beginnen.","Drive # over an obstacle":"# über ein Hindernis fahren",", and keep the run.":" und den Lauf aufbewahren.","Change # and keep another run":"# ändern und noch einen Lauf aufbewahren",", to compare the two.":", um beide zu vergleichen.","Look at # beside a run":"# neben einem Lauf ansehen","Vary its numbers in a study":"Seine Zahlen in einer Studie variieren","What to do next":"Was als Nächstes zu tun ist","compare #":"# vergleichen","Compare those that are chosen":"Gewählte vergleichen","Choose one or more of them.":"Einen oder mehrere wählen.",run:"Lauf",rig:"Fahrwerk",vehicle:"Fahrzeug",road:"Straße",record:"Messung",page:"Seite",results:"Ergebnisse",campaign:"Kampagne",design:"Entwurf",sweep:"Studie",edit:"bearbeiten","drive it":"fahren",kinematics:"Kinematik","look at it":"ansehen","beside a run":"neben einem Lauf",changes:"Änderungen",trial:"Versuch",inputs:"Eingaben",seed:"Startwert",version:"Version","kept (UTC)":"aufbewahrt (UTC)",compare:"vergleichen",time:"Zeit",channels:"Kanäle","zoom in":"vergrößern","zoom out":"verkleinern","to the left":"nach links","to the right":"nach rechts",All:"Alles",everything:"alles","# samples":"# Werte",every:"alle","not evenly spaced":"nicht in gleichen Abständen","units as they are in the file":"Einheiten wie in der Datei","Beside a run":"Neben einem Lauf","not shown":"nicht gezeigt","There is nothing in it but time.":"Außer der Zeit ist nichts darin.","Drag to zoom, Shift + wheel or ← → pans, Ctrl + wheel zooms, double click for everything.":"Ziehen vergrößert, Umschalt + Rad oder ← → verschiebt, Strg + Rad zoomt, Doppelklick für alles.","text of #":"Text von #",Save:"Speichern",Undo:"Rückgängig",Redo:"Wiederherstellen","The mechanism":"Der Mechanismus","Drag a hardpoint, or choose it and type its place; drag beside them to turn the picture.":"Einen Kinematikpunkt ziehen, oder ihn wählen und seinen Ort eintippen; daneben ziehen dreht das Bild.","#: nothing is wrong with it.":"#: nichts ist daran falsch.","# numbers":"# Zahlen","Write it":"Schreiben",Back:"Zurück","Saved.":"Gespeichert.","Load it again":"Neu laden","What is changed":"Was geändert wird","Something is still wrong with it; it can be saved all the same.":"Etwas daran ist noch falsch; speichern lässt es sich trotzdem.","Drive it over an obstacle":"Über ein Hindernis fahren","Look at its kinematics":"Seine Kinematik ansehen",Form:"Formular",File:"Datei","frequency (spectra)":"Frequenz (Spektren)","Keep this run as":"Diesen Lauf aufbewahren als","Keep it":"Aufbewahren","Kept as ":"Aufbewahrt als ","Compare it in the project":"Im Projekt vergleichen","# over an obstacle":"# über ein Hindernis","What is run":"Was gefahren wird",Obstacle:"Hindernis",Speed:"Geschwindigkeit",Duration:"Dauer",Height:"Höhe",Length:"Länge",Depth:"Tiefe","half sine":"Halbsinus",rectangle:"Rechteck",triangle:"Dreieck",step:"Stufe",pothole:"Schlagloch","Beside a recording":"Neben einer Messung","Where it begins":"Wo sie beginnt","Keep this run":"Diesen Lauf aufbewahren",Copy:"Kopieren",Copied:"Kopiert","Select and copy":"Markieren und kopieren","The same in Python":"Dasselbe in Python","The same on the command line":"Dasselbe auf der Kommandozeile","another number":"eine andere Zahl","another number …":"eine andere Zahl …","All as they were":"Alle wie zuvor","Phase plot":"Phasenbild",Across:"Waagerecht",Upward:"Senkrecht",over:"über",Hardpoint:"Kinematikpunkt","in the plane of the picture":"in der Bildebene","along x":"entlang x","along y":"entlang y","along z":"entlang z",Dragged:"Ziehen","Snaps to":"Raster","No rig lies here yet: ":"Hier liegt noch kein Fahrwerk: ","Nothing of that kind lies here yet: ":"Hier liegt noch nichts dergleichen: ","to the project":"zum Projekt","Show the results":"Ergebnisse zeigen",Resume:"Fortsetzen","Begin again":"Neu beginnen","Take off the list":"Aus der Liste nehmen","In Python, and on the command line":"In Python und auf der Kommandozeile","asking …":"fragt …","open it in a tab of its own":"in einem eigenen Reiter öffnen","working …":"arbeitet …","stopping; what is finished is kept":"hält an; was fertig ist, bleibt","Long work goes on when this page is closed, and when the server is ended: it is found again here.":"Lange Arbeit läuft weiter, wenn diese Seite geschlossen oder der Server beendet wird: hier findet sie sich wieder.","No long work was begun here yet. Studies, campaigns, rides and designs begin it.":"Hier wurde noch keine lange Arbeit begonnen. Studien, Kampagnen, Fahrten und Entwürfe beginnen sie.","Start from it":"Damit beginnen",Folder:"Ordner",Campaigns:"Kampagnen",Runs:"Läufe","No campaign was run here yet.":"Hier lief noch keine Kampagne.","A campaign to start from":"Eine Kampagne zum Anfangen","It runs as it is, with synthetic recordings.":"Sie läuft, wie sie ist, mit synthetischen Messungen.","Run the campaign":"Kampagne durchführen","Check it":"Prüfen","Nothing is wrong with it.":"Nichts ist daran falsch.","All campaigns":"Alle Kampagnen","Folder of the results":"Ordner der Ergebnisse","Replace what is there":"Vorhandenes ersetzen",Parts:"Teile","Nothing was measured of the parts: the rig is taken as its file says.":"An den Teilen wurde nichts gemessen: das Fahrwerk gilt, wie es in der Datei steht.",Trials:"Versuche","tyre pressure":"Reifendruck","measured support":"gemessene Unterlage",Updates:"Abgleiche",Measurements:"Messungen","Folder they go to":"Ordner dafür","Drop measured files here, or choose them (up to 250 MB each).":"Messdateien hier ablegen oder wählen (je bis 250 MB).","Separate damping and friction":"Dämpfung und Reibung trennen","Fit the stiffness":"Steifigkeit bestimmen","Decay and its bend by friction":"Abklingen und seine Krümmung durch Reibung","Fit, with the discarded zone":"Ausgleich, mit dem verworfenen Bereich","Oscillating mass":"Schwingende Masse",From:"Von",To:"Bis",Law:"Gesetz","Ignore smaller deflections":"Kleinere Wege nicht werten","Force at zero":"Kraft bei null","a trial":"ein Versuch","a free decay":"ein freies Ausschwingen","the spring":"die Feder","a tyre at a pressure":"ein Reifen bei einem Druck","judges only (hold-out)":"urteilt nur (zurückgehalten)","is fitted":"wird abgeglichen",Road:"Straße","File of the support":"Datei der Unterlage","Its height counts from":"Ihre Höhe zählt ab","Tyre pressure":"Reifendruck",Use:"Verwendung","In place of the files there":"Anstelle der Dateien dort",Pressure:"Druck","Enter it into the campaign":"In die Kampagne eintragen",Report:"Bericht","at its bound":"an der Grenze","The search goes on":"Die Suche läuft","The last search":"Die letzte Suche","lower bound":"untere Grenze","upper bound":"obere Grenze","at first":"anfangs",Verdicts:"Urteile",Characterised:"Kennwerte","in the rig's file":"in der Datei des Fahrwerks","What the data can tell":"Was die Daten hergeben","most alike":"am ähnlichsten","Every update on every trial":"Jeder Abgleich an jedem Versuch","What to be careful about":"Worauf zu achten ist","Numbers of a rig are spread over ranges or distributions; every variant is simulated, and what its metrics depend on is told.":"Zahlen eines Fahrwerks werden über Bereiche oder Verteilungen gestreut; jede Variante wird simuliert, und gezeigt wird, wovon ihre Kennwerte abhängen.",Sweeps:"Variationen","No sweep was begun here yet. Write a study below, or begin one that lies in the folder.":"Hier wurde noch keine Variation begonnen. Unten eine Studie schreiben oder eine aus dem Ordner beginnen.","Studies that lie here":"Studien, die hier liegen","A new study":"Eine neue Studie",Begin:"Beginnen","No rig lies here yet.":"Hier liegt noch kein Fahrwerk.","random road (ISO 8608)":"stochastische Straße (ISO 8608)","number that varies":"Zahl, die variiert","how it is spread":"wie sie gestreut wird","this number":"diese Zahl",Class:"Klasse","Write the study":"Studie schreiben","Write it and begin":"Schreiben und beginnen","Another number":"Noch eine Zahl","what varies":"was variiert",Design:"Versuchsplan",Count:"Anzahl",Seed:"Startwert","Metrics, with commas between":"Kennwerte, durch Kommas getrennt","File of the study":"Datei der Studie","All studies":"Alle Studien","No variant is finished yet.":"Noch keine Variante ist fertig.","All variants":"Alle Varianten","open as a trial":"als Fahrversuch öffnen",Metrics:"Kennwerte","What they depend on":"Wovon sie abhängen",Variants:"Varianten","Drag along an axis to keep the variants that pass there; a click on it lets all pass again.":"Entlang einer Achse ziehen, um die dortigen Varianten zu behalten; ein Klick darauf lässt wieder alle zu.","chosen variants":"gewählte Varianten","The first of the chosen variants":"Die ersten der gewählten Varianten","standard deviation":"Standardabweichung","not stated":"nicht angegeben",Preview:"Vorschau",Stroke:"Hub",Force:"Kraft","Sample time, where the file has none":"Abtastzeit, wo die Datei keine hat","Variable or group (.mat, .tdms)":"Variable oder Gruppe (.mat, .tdms)",Columns:"Spalten","column of the file":"Spalte der Datei","read as":"gelesen als","unit, where the file has none":"Einheit, wo die Datei keine hat","parallel coordinates":"parallele Koordinaten","Ranges as numbers":"Bereiche als Zahlen","wide table":"breite Tabelle","matrix of dots":"Matrix aus Punkten","The server does not tell about jobs any more; those that run go on. Start it again with jounce serve, and open the address that it prints.":"Der Server meldet nichts mehr von Aufträgen; laufende gehen weiter. Mit jounce serve neu starten und die ausgegebene Adresse öffnen.","Mean error of the channels (NRMSE) before and after each update; trials it was fitted on are marked.":"Mittlerer Fehler der Kanäle (NRMSE) vor und nach jedem Abgleich; Versuche, an denen abgeglichen wurde, sind gekennzeichnet.","BOGE amplitude":"BOGE-Amplitude","Records of shock-absorber testers: read, evaluated, graded against limits, put on a protocol, and kept in a store.":"Messungen von Stoßdämpferprüfständen: gelesen, ausgewertet, an Grenzwerten bewertet, protokolliert und in einem Archiv aufbewahrt.","Evaluate a record":"Eine Messung auswerten","New records":"Neue Messungen","Drop records of a tester here, or choose them; they go to the folder records.":"Messungen eines Prüfstands hier ablegen oder wählen; sie kommen in den Ordner records.","No record at hand? Simulate a test":"Keine Messung zur Hand? Eine Prüfung simulieren",Store:"Archiv","No store lies here yet: name one above (lane.sqlite), and what is evaluated is kept in it.":"Hier liegt noch kein Archiv: oben eines nennen (lane.sqlite), dann wird Ausgewertetes darin aufbewahrt.","No record lies here yet.":"Hier liegt noch keine Messung.","Look at the record":"Messung ansehen","Evaluate and grade":"Auswerten und bewerten",Protocol:"Protokoll","Record of one axle":"Messung einer Achse","Record of the other axle":"Messung der anderen Achse",Tester:"Prüfstand","Method that decides":"Entscheidendes Verfahren",Vehicle:"Fahrzeug","Number plate":"Kennzeichen",Date:"Datum",Inspector:"Prüfer","Language of the protocol":"Sprache des Protokolls","Keep it in the store":"Im Archiv aufbewahren","Simulate the test":"Prüfung simulieren","Evaluate it":"Auswerten","Rig or vehicle":"Fahrwerk oder Fahrzeug","Loss of damping":"Verlust an Dämpfung",Wheel:"Rad",Record:"Messung","No record fits.":"Keine Messung passt.",Again:"Noch einmal","Every visit":"Jeder Besuch","Number plate, or a pattern":"Kennzeichen oder Muster",Verdict:"Urteil","First day":"Erster Tag","Last day":"Letzter Tag","One visit tells no trend.":"Ein Besuch zeigt keinen Verlauf.","Change per year":"Änderung je Jahr","Rides over each other":"Fahrten übereinander","Rides that are done":"Fahrten, die fertig sind","Drive first: every ride that is done can be chosen here.":"Zuerst fahren: jede fertige Fahrt lässt sich hier wählen.","Draw them":"Zeichnen","Ride and control":"Fahren und Regeln",Controllers:"Regler",Drive:"Fahren","Vehicle or rig":"Fahrzeug oder Fahrwerk","A vehicle over a rough road, passive and with controllers: comfort beside travel and road holding, in numbers, over time and as spectra.":"Ein Fahrzeug auf unebener Straße, passiv und geregelt: Komfort neben Federweg und Bodenhaftung, in Zahlen, über der Zeit und als Spektren.","Best designs":"Beste Entwürfe","Rides and fronts":"Fahrten und Fronten","Nothing was driven here yet.":"Hier wurde noch nichts gefahren.","From the most comfortable design to the one that holds the road best; each of them opens as a ride.":"Vom komfortabelsten Entwurf zu dem mit der besten Bodenhaftung; jeder öffnet sich als Fahrt.",Designs:"Entwürfe","Most travel r.m.s., if any":"Größter Federweg (Effektivwert), falls begrenzt","All rides":"Alle Fahrten","Over time, as spectra, and every metric":"Über der Zeit, als Spektren, und alle Kennwerte","Smaller is better; in brackets the change from the passive rig":"Kleiner ist besser; in Klammern die Änderung gegenüber dem passiven Fahrwerk","Pareto front":"Pareto-Front","Not every design is surely the best of its kind.":"Nicht jeder Entwurf ist sicher der beste seiner Art.","Sobol: even over all numbers":"Sobol: gleichmäßig über alle Zahlen","Latin hypercube":"Lateinischer Hyperwürfel","Monte Carlo: random":"Monte Carlo: zufällig","Grid: every combination":"Gitter: jede Kombination","List: one value of each a variant":"Liste: je Variante ein Wert","Morris: screening by trajectories":"Morris: Sichtung durch Bahnen","Saltelli: indices of the variance":"Saltelli: Varianzindizes","What is finished by now":"Was bisher fertig ist","From measurements of springs, tyres, decays and trials to a model that holds: characterised, updated, compared with every trial.":"Von Messungen an Federn, Reifen, Ausschwingversuchen und Fahrversuchen zu einem Modell, das hält: gekennzeichnet, angepasst, mit jedem Versuch verglichen.","that of the tester":"das des Prüfstands","not known":"nicht bekannt","its bounds":"ihre Grenzen","number that is free":"freie Größe","± share":"± Anteil",range:"Bereich",normal:"normalverteilt",triangular:"dreieckverteilt",values:"Werte","look at #":"# ansehen","leave out #":"# weglassen","is #":"ist #","no number of this rig":"keine Größe dieses Fahrwerks",use:"Verwendung",recording:"Messung",free:"frei",trials:"Fahrversuche",method:"Verfahren",name:"Name",running:"läuft",stopping:"hält an",done:"fertig",failed:"fehlgeschlagen",cancelled:"abgebrochen",stopped:"angehalten",starting:"beginnt","took #":"dauerte #","for #":"seit #","about # left":"noch etwa #","share of # that is done":"erledigter Anteil von #","Campaign #":"Kampagne #","Sweep #":"Variation #","Sweep in #":"Variation in #","Kinematic design #":"Kinematischer Entwurf #","Best designs of #":"Beste Entwürfe von #","Show the results: #":"Ergebnisse zeigen: #","Take off the list: #":"Aus der Liste nehmen: #","Cancel: #":"Abbrechen: #","Resume: #":"Fortsetzen: #","Begin again: #":"Neu beginnen: #",drawing:"zeichnet",searching:"sucht",loading:"lädt","writing the report":"schreibt den Bericht","reading the study":"liest die Studie","simulating # variants: # %":"simuliert # Varianten: # %","driving # of #: #":"fährt # von #: #","measured: ":"gemessen: ",speed:"Geschwindigkeit","It is a measurement of":"Gemessen wurde","positive in compression":"positiv beim Zusammendrücken","positive in extension":"positiv beim Auseinanderziehen","positive in tension":"positiv auf Zug","none: the support is measured":"keine: die Unterlage ist gemessen","what # is read as":"als was # gelesen wird","unit of #":"Einheit von #","# samples as they would be read":"# Werte, wie sie gelesen würden",quantity:"Größe",value:"Wert","95 % interval":"95-%-Intervall",from:"von",to:"bis",parameter:"Parameter",now:"jetzt","error of the channels (NRMSE)":"Fehler der Kanäle (NRMSE)",verdict:"Urteil","verdict: ":"Urteil: ","speed [m/s]":"Geschwindigkeit [m/s]",measured:"gemessen","standard error":"Standardfehler","95 % interval, noise only":"95-%-Intervall, nur Rauschen",bounds:"Grenzen",known:"bekannt",unknown:"Unbekannte",sensitivity:"Empfindlichkeit",update:"Abgleich","Update: #":"Abgleich: #","trial #":"Versuch #",holds:"hält","holds partly":"hält teilweise","does not hold":"hält nicht",", fitted":", angepasst",identified:"bestimmt","not identified: #":"nicht bestimmt: #","# between its bounds":"# zwischen seinen Grenzen","The objective fell by # %, from # to #, in # evaluations on trial #.":"Die Zielfunktion fiel um # %, von # auf #, in # Auswertungen an Versuch #.","# of # directions are told apart; the condition is #.":"# von # Richtungen lassen sich unterscheiden; die Konditionszahl ist #.","objective, logarithmic: # at first, # after # evaluations":"Zielfunktion, logarithmisch: # am Anfang, # nach # Auswertungen",controller:"Regler",comfort:"Komfort","road holding":"Bodenhaftung","design #":"Entwurf #","closed form":"geschlossene Formel",searched:"gesucht",present:"vorhanden","as it is (present)":"wie vorhanden","best damper for comfort (closed form)":"bester Dämpfer für Komfort (geschlossene Formel)","best damper for comfort (searched)":"bester Dämpfer für Komfort (gesucht)","best damper for road holding (closed form)":"bester Dämpfer für Bodenhaftung (geschlossene Formel)","best damper for road holding (searched)":"bester Dämpfer für Bodenhaftung (gesucht)","drive #, as a ride":"# als Fahrt öffnen","#: drive it":"#: fahren","body, weighted r.m.s. (Wk)":"Aufbau, bewerteter Effektivwert (Wk)","body r.m.s.":"Aufbau, Effektivwert","strut travel r.m.s., worst corner":"Federweg, Effektivwert, schlechteste Ecke","strut travel, whole range, worst corner":"Federweg, ganzer Bereich, schlechteste Ecke","dynamic wheel load coefficient, worst corner":"dynamischer Radlastkoeffizient, schlechteste Ecke","time lifted off, worst corner":"Zeit ohne Bodenkontakt, schlechteste Ecke","not uncomfortable":"nicht unbehaglich","a little uncomfortable":"etwas unbehaglich","fairly uncomfortable":"ziemlich unbehaglich",uncomfortable:"unbehaglich","very uncomfortable":"sehr unbehaglich","extremely uncomfortable":"äußerst unbehaglich","#; round: the front, square: the rig as it is and single best dampers. Each opens as a ride.":"#; rund: die Front, eckig: das Fahrwerk, wie es ist, und einzelne beste Dämpfer. Jeder Punkt öffnet sich als Fahrt.","low..high unit, or ±30 %":"von..bis Einheit, oder ±30 %","note: #":"Hinweis: #","warning: #":"Warnung: #","not run: #":"nicht gefahren: #","#: it has one corner, which is drawn as #, its sprung mass as the body, too.":"#: eine Ecke, gezeichnet als #, die gefederte Masse auch als Aufbau.","#: its axles are drawn as left corners.":"#: die Achsen sind als linke Ecken gezeichnet.",store:"Archiv",inspect:"prüfen",pass:"bestanden",advise:"Hinweis",fail:"nicht bestanden","not graded":"nicht bewertet","static load":"statische Radlast","adhesion (EUSAMA)":"Bodenhaftung (EUSAMA)","least phase angle (EGEA)":"kleinster Phasenwinkel (EGEA)","relative force amplitude":"relative Kraftamplitude","tyre rigidity":"Reifensteifigkeit","damping ratio on the tester (THETA)":"Dämpfungsgrad, Prüfstand (THETA)","damping ratio on the road (THETA)":"Dämpfungsgrad, Straße (THETA)",at:"bei",wheel:"Rad",left:"links",right:"rechts",front:"vorn",rear:"hinten","# decides; limits: #":"# entscheidet; Grenzwerte: #","kept in the store as record #":"im Archiv als Messung #","Why (#)":"Begründung (#)","grade #":"Stufe #",any:"beliebig",date:"Datum",plate:"Kennzeichen",axle:"Achse",tester:"Prüfstand","1 record":"1 Messung","# records":"# Messungen","history of #":"Verlauf von #","History of #":"Verlauf von #",history:"Verlauf","change per year":"Änderung je Jahr",visits:"Besuche",spread:"Streuung","into #":"nach #",metric:"Kennwert",mean:"Mittelwert",least:"kleinster",greatest:"größter","regression coefficient":"Regressionskoeffizient","share of the variance, with others":"Anteil an der Varianz, mit Wechselwirkung","mean size of effects":"mittlere Größe der Wirkung",low:"niedrig",high:"hoch",variant:"Variante","mark variant #":"Variante # markieren","open variant # as a trial":"Variante # als Versuch öffnen","# of # variants":"# von # Varianten"," shown, of #":" gezeigt, von #","; variant # is marked":"; Variante # ist markiert","# of # variants are finished":"# von # Varianten sind fertig",versine:"Versinus"});var t_=["aria-label","title","placeholder"];function h(i,e={},...t){let n=document.createElement(i);for(let[r,a]of Object.entries(e))typeof a=="function"?n.addEventListener(r,a):typeof a=="boolean"?n.toggleAttribute(r,a):n.setAttribute(r,t_.includes(r)?Vi(a):a);let s=e.scope==="col"||/^mark\b/.test(String(e.class??""));return n.append(...t.map(r=>typeof r!="string"?r:s&&F(r)!==r?F(r):Vi(r))),n}function pi(i,e,t,n=""){let s=h("button",{type:"button","aria-pressed":String(e),title:n},i);return s.addEventListener("click",()=>{let r=s.getAttribute("aria-pressed")!=="true";s.setAttribute("aria-pressed",String(r)),t(r)}),s}function xe(i,e=4){if(i==null||Number.isNaN(i))return"–";if(!Number.isFinite(i))return i>0?"∞":"−∞";if(i===0)return"0";let[t,n]=i.toExponential(e-1).split("e"),s=Number(n),r=s<-4||s>5?`${t}e${s}`:i.toFixed(Math.max(0,e-1-s));return fi(r)}function vo(i,e){if(!Number.isFinite(i)||!(e>0))return xe(i);let t=Math.min(Math.max(0,Math.ceil(-Math.log10(e))),100),n=Number(i.toFixed(t));return n===0?"0":xe(n)}function xt(i){return getComputedStyle(document.documentElement).getPropertyValue(`--${i}`).trim()||"#888"}var Pu=null;function _o(){if(Pu===null){let i=document.createElement("canvas").getContext("webgl2",{failIfMajorPerformanceCaveat:!0}),e=i?.getExtension("WEBGL_debug_renderer_info"),t=e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";Pu=i!==null&&!/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t),i?.getExtension("WEBGL_lose_context")?.loseContext()}return Pu}var Iu=new Set;function jn(i){Iu.add(i)}var Lu=new Set;function ha(i){Lu.add(i)}function mp(){for(let i of Lu)i();Lu.clear(),Iu.clear()}function pp(){for(let i of Iu)i()}function gp(){let i=matchMedia("(prefers-color-scheme: dark)"),e=document.documentElement,t=()=>e.dataset.theme?e.dataset.theme==="dark":i.matches,n=h("button",{type:"button",class:"theme"}),s=()=>{n.textContent=St(t()?"light":"dark"),n.title=St(t()?"showLight":"showDark")};return n.addEventListener("click",()=>{e.dataset.theme=t()?"light":"dark",s(),pp()}),i.addEventListener("change",()=>{s(),pp()}),s(),n}var ua={"out of range":"außerhalb des Bereichs","not a number":"keine Zahl","not a finite number":"keine endliche Zahl","not finite numbers":"keine endlichen Zahlen","not a number with a unit":"keine Zahl mit Einheit","not a physical value":"keine physikalische Größe","wrong unit":"falsche Einheit","the unit is missing":"die Einheit fehlt","the unit does not fit":"die Einheit passt nicht","not a size that anything has":"keine Größe, die etwas haben kann","not a text":"kein Text","not a path":"kein Pfad","not a name":"kein Name","not a text file":"keine Textdatei","not a list of values":"keine Liste von Werten","not a list of finite numbers":"keine Liste endlicher Zahlen","not a range":"kein Bereich","not a step":"keine Schrittweite","not a direction":"keine Richtung","not a distance":"keine Strecke","not a seed":"kein Startwert","not a share":"kein Anteil","not a metric":"kein Kennwert","not a weight":"kein Gewicht","not a rig":"kein Fahrwerk","not a road":"keine Straße","not a road class":"keine Straßenklasse","not a hardpoint":"kein Kinematikpunkt","not a folder":"kein Ordner","a file, not a folder":"eine Datei, kein Ordner","not a standard deviation":"keine Standardabweichung","not a distribution":"keine Verteilung","not a number of variants":"keine Anzahl von Varianten","not a number of searches":"keine Anzahl von Suchläufen","not a name for a run":"kein Name für einen Lauf","not a place in this project":"keine Stelle in diesem Projekt","not a description":"keine Beschreibung","not a date":"kein Datum","no such parameter":"keine solche Größe","no such file":"keine solche Datei","no such quantity":"keine solche Kenngröße","no such job":"kein solcher Auftrag","no such version":"keine solche Fassung","no such place in this text":"keine solche Stelle in diesem Text","no rack moves this wheel":"keine Zahnstange bewegt dieses Rad","no file of measurements":"keine Messdatei","no limit":"keine Grenze","nothing to sweep":"nichts zu durchlaufen","nothing to vary":"nichts zu verändern","nothing is given":"nichts angegeben","nothing to spread over":"nichts, worüber gestreut wird","no number varies":"keine Größe verändert sich","a share of zero":"ein Anteil von null","no whole number lies within":"keine ganze Zahl liegt darin","the mode lies outside its range":"der häufigste Wert liegt außerhalb seines Bereichs","too many values":"zu viele Werte","too many poses":"zu viele Stellungen","too many poses to be waited for":"zu viele Stellungen, um darauf zu warten","too long to be waited for":"zu lang, um darauf zu warten","too many results":"zu viele Ergebnisse","too many jobs run":"zu viele Aufträge laufen","too long for a description":"zu lang für eine Beschreibung","this takes too long":"das dauert zu lange","cannot be read or written":"nicht zu lesen oder zu schreiben","the file cannot be written":"die Datei lässt sich nicht schreiben","the folder cannot be written":"der Ordner lässt sich nicht schreiben","the file is empty":"die Datei ist leer","the file exists":"die Datei gibt es schon","the output exists":"die Ausgabe gibt es schon","the file did not arrive whole":"die Datei kam nicht vollständig an","the file is too large for a description":"die Datei ist zu groß für eine Beschreibung","the file would lie outside the folder":"die Datei läge außerhalb des Ordners","a job writes there already":"ein Auftrag schreibt schon dorthin","the job runs":"der Auftrag läuft","the job wrote no report":"der Auftrag schrieb keinen Bericht","the report is not kept any more":"der Bericht ist nicht mehr aufbewahrt","only descriptions are written here":"hier werden nur Beschreibungen geschrieben","the file was changed meanwhile":"die Datei wurde inzwischen geändert","the recording holds nothing of the trial's time":"die Messung enthält nichts von der Zeit des Fahrversuchs","no time":"keine Zeit","time does not ascend":"die Zeit steigt nicht an","the values do not ascend":"die Werte steigen nicht an","the values have different lengths":"die Werte sind verschieden lang","the curve does not ascend":"die Kurve steigt nicht an","the curve has one point":"die Kurve hat einen Punkt","the curve does not reach zero":"die Kurve reicht nicht bis null","the number is missing":"die Zahl fehlt","the row does not have as many cells as the header":"die Zeile hat nicht so viele Zellen wie die Kopfzeile","text in a number column":"Text in einer Zahlenspalte","the cell is blank":"die Zelle ist leer","decimal comma":"Dezimalkomma","decimal commas and decimal points in one file":"Dezimalkommas und Dezimalpunkte in einer Datei","the header is missing":"die Kopfzeile fehlt","the header has no unit":"die Kopfzeile hat keine Einheit","a header but no rows of numbers":"eine Kopfzeile, aber keine Zeilen mit Zahlen","the channel is missing":"der Kanal fehlt","two points are the same, or three lie on one line":"zwei Punkte sind gleich, oder drei liegen auf einer Linie","the spring's lengths contradict each other":"die Längen der Feder widersprechen sich","left and right points lie on the same side":"linke und rechte Punkte liegen auf derselben Seite","the wheel is not on the road":"das Rad steht nicht auf der Straße","there is no controller":"es gibt keinen Regler","the loops cannot be closed":"die Schleifen lassen sich nicht schließen","the run did not reach its end":"der Lauf kam nicht ans Ende","the road is shorter than the run":"die Straße ist kürzer als die Fahrt","this rig has no hardpoints":"dieses Fahrwerk hat keine Kinematikpunkte","a trial has its own road":"ein Fahrversuch hat seine eigene Straße","no road to drive over":"keine Straße zum Befahren","no speed to drive at":"keine Geschwindigkeit","the campaign has no update":"die Kampagne hat keine Modellanpassung","no trial to fit":"kein Fahrversuch zum Anpassen","too few samples":"zu wenige Messwerte","too few rows":"zu wenige Zeilen","no static equilibrium":"kein statisches Gleichgewicht","no target is given":"kein Ziel angegeben","nothing is judged by it":"nichts wird danach beurteilt","the output folder is not empty":"der Ausgabeordner ist nicht leer",required:"erforderlich","not known here":"hier nicht bekannt","a finite number":"eine endliche Zahl","a whole number":"eine ganze Zahl","a lower and a higher value":"ein kleinerer und ein größerer Wert"},n_={channel:"Kanal",key:"Schlüssel",road:"Straße",metric:"Kennwert",model:"Modell",controller:"Regler",quantity:"Kenngröße","kind of road":"Art von Straße"};function mi(i){let e=i.replace(" or allow it with --force.",i.includes("the output folder is not empty")?", or begin it again, which replaces what is there.":".");if(!ca)return e;let[t,...n]=e.split(/(?=; (?:found|allowed:) )/),s=n.map(r=>r.replace(/^; found /,"; gefunden ").replace(/^(; )allowed: ([^.?]*(?:\.\d[^.?]*)*)/,(a,o,l)=>`${o}zulässig: ${i_(l)}`));return r_(vp(t)+s.join(""))}function vp(i){let e=i.indexOf(": "),t=/^(.*?)([.?]?(?: .*)?)$/s.exec(i);if(ua[i])return ua[i];let[,n,s]=/^([^.]*)(\.?(?: [A-Z].*)?)$/s.exec(i)??t;if(ua[n])return ua[n]+s;let r=/^unknown ([a-z ]+) ('.*')(.*)$/s.exec(i);return r?`${n_[r[1]]??r[1]} ${r[2]} ist nicht bekannt${r[3]}`:e>0?i.slice(0,e+2)+vp(i.slice(e+2)):i}function i_(i){return ua[i]?ua[i]:/^(above|at least|at most)\b/.test(i)?i.replaceAll("above ","über ").replaceAll("at least ","mindestens ").replaceAll("at most ","höchstens "):i}var s_={"Choose another name, or begin it again, which replaces what is there.":"Einen anderen Namen wählen oder neu beginnen, was Vorhandenes ersetzt.","Choose another name.":"Einen anderen Namen wählen.","Check the path, the permissions and the space on the disk.":"Pfad, Rechte und Platz auf der Platte prüfen.","Wait for it, or choose another folder.":"Darauf warten oder einen anderen Ordner wählen.","Wait for one of them, or cancel it.":"Auf einen warten oder ihn abbrechen.","Load it again, and make your change there.":"Neu laden und die Änderung dort machen.","Check the path and the name.":"Pfad und Namen prüfen.","Drive for longer (duration).":"Länger fahren (Dauer).","Fill the gap or remove the row.":"Die Lücke füllen oder die Zeile löschen.","Fill it or remove the row.":"Sie füllen oder die Zeile löschen.","Choose one of the project.":"Eine aus dem Projekt wählen.","Cancel it first.":"Ihn zuerst abbrechen.","Check spelling and case, e.g. ":"Schreibweise prüfen, z. B. ","Map it with columns, or give the sample time.":"Sie mit den Spalten zuordnen oder die Abtastzeit angeben.","Map columns to channels with columns.":"Spalten den Kanälen zuordnen."};function r_(i){let e=i.replace(/a unit that converts to ([^.;]*?)(?=[.;]|$)/,"eine Einheit, die sich in $1 umrechnen lässt");for(let[t,n]of Object.entries(s_))e=e.replace(t,n);return e.replace(/Did you mean (.*?)\?/,(t,n)=>`Ist ${n.replace(" or "," oder ")} gemeint?`).replace(/All (\d+): /,"Alle $1: ").replace(/Known: /,"Bekannt: ")}async function Bn(i,e,t,n="application/json"){let s=t===void 0?{}:{body:JSON.stringify(t),headers:{"Content-Type":"application/json",Accept:n}},r;try{r=await fetch(e,{method:i,...s})}catch{throw new Error(F("The server does not answer: start it again with jounce serve."))}if(r.ok)return r;if(r.status===401)throw new Error(F("This page is not known here any more: open the address that jounce serve printed."));let a=await r.json().catch(()=>null);throw new Error(mi(a?.error?.text??a?.detail?.map(o=>`${o.loc.slice(1).join(".")}: ${o.msg}`).join("; ")??r.statusText))}var ii=i=>new URLSearchParams(i).toString(),en=async i=>(await Bn("GET",i)).json(),Ln=()=>en("/api/project"),Ri=()=>en("/api/library"),Er=i=>en(`/api/file?${ii({path:i})}`),_p=i=>en(`/api/versions?${ii({path:i})}`),yp=async i=>{let e=await en(`/api/check?${ii({path:i})}`);return{...e,problems:e.problems.map(mi)}},ls=i=>en(`/api/rig?${ii({name:i})}`),xp=async(i,e)=>(await Bn("POST","/api/library",{name:i,path:e})).json(),Tr=async(i,e,t)=>(await Bn("PUT","/api/file",{path:i,text:e,was:t})).json(),Du=new Map;function bp(i){let e=Du.get(i);return e||(e=en(`/api/schema?${ii({model:i})}`),Du.set(i,e),e.catch(()=>Du.delete(i))),e}var Gi=async(i,e,t,n)=>{let s=await(await Bn("POST","/api/form",{path:i,text:e,sets:t,changes:n})).json();return{...s,problems:s.problems.map(r=>({...r,text:mi(r.text)}))}},yo=async(i,e)=>(await Bn("POST",i,e,"application/octet-stream")).arrayBuffer(),da=(i,e)=>yo(`/api/${i}`,e);var zn=class i{constructor(e,t){this.content=e;this.bytes=t}content;bytes;made=[];straight=null;static async open(e){let t=JSON.parse(e),n=atob(t.packed);t.packed="";let s=new Uint8Array(n.length);for(let a=0;a<n.length;a++)s[a]=n.charCodeAt(a);let r=new Blob([s]).stream().pipeThrough(new DecompressionStream("deflate"));return new i(t,new Uint8Array(await new Response(r).arrayBuffer()))}static of(e){let t=new DataView(e).getUint32(0,!0),n=4+t,s=JSON.parse(new TextDecoder().decode(new Uint8Array(e,4,t))),r=new i(s,new Uint8Array(0));r.straight=o=>new Float64Array(e,n+s.arrays[o].at,s.arrays[o].n);let a=o=>{let l=r.straight(o);return Array.from({length:l.length/3},(c,u)=>l.subarray(3*u,3*u+3))};for(let o of s.mechanisms){let{points:l,spin:c,contact:u}=o;Object.assign(o,{points:l.map(a),spin:a(c),contact:a(u)})}return r}step(e){let{even:t,step:n}=this.content.arrays[e];return t?0:n||this.finest(e)}finest(e){let t=this.get(e),n=1/0,s=-1/0;for(let r=0;r<t.length;r++){let a=t[r];a!=null&&(a<n&&(n=a),a>s&&(s=a))}return s>n?(s-n)*1e-7:0}get(e){return this.made[e]??=this.straight?a_(this.straight(e)):o_(this.content.arrays[e],this.bytes)}};function a_(i){return i.some(Number.isNaN)?Array.from(i,e=>Number.isNaN(e)?null:e):i}var wp=65535;function o_(i,e){let{n:t,at:n,order:s,low:r,step:a,even:o}=i;if(o)return Float64Array.from({length:t},(f,p)=>o[0]+p*o[1]);let l=new Float64Array(t),c=0,u=0,d=!1;for(let f=0;f<t;f++){let p=e[n+f]|e[n+t+f]<<8;if(s===0)c=p;else{let g=p>>>1^-(p&1);s===1?c=c+g&65535:(u=u+g&65535,c=c+u&65535)}c===wp&&(d=!0),l[f]=c===wp?NaN:r+a*c}return d?Array.from(l,f=>Number.isNaN(f)?null:f):l}function Li(i,e,t){let n=i.length;if(n===0)return NaN;let s=xo(i,t),r=Math.min(s+1,n-1),a=i[s],o=i[r],l=e[s],c=e[r];if(l===null||c===null||l===void 0||c===void 0)return NaN;let u=o>a?Math.min(1,Math.max(0,(t-a)/(o-a))):0;return l+u*(c-l)}function xo(i,e){let t=0,n=i.length-1;for(;n>t;){let s=t+n+1>>1;i[s]<=e?t=s:n=s-1}return t}var lr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},cr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},em=0,ud=1,tm=2;var nl=1,nm=2,Ua=3,hr=0,ti=1,ai=2,kr=0,Oa=1,dd=2,fd=3,pd=4,im=5;var Fr=100,sm=101,rm=102,am=103,om=104,lm=200,cm=201,hm=202,um=203,md=204,gd=205,dm=206,fm=207,pm=208,mm=209,gm=210,vm=211,_m=212,ym=213,xm=214,sc=0,rc=1,ac=2,Aa=3,oc=4,lc=5,cc=6,hc=7,Wc=0,bm=1,wm=2,fs=0,vd=1,_d=2,yd=3,xd=4,bd=5,wd=6,Sd=7;var Md=300,Ur=301,Ba=302,$c=303,Xc=304,uc=1e3,hs=1001,dc=1002,Dn=1003,Sm=1004;var il=1005;var Jn=1006,qc=1007;var Fs=1008;var oi=1009,Ed=1010,Td=1011,za=1012,Yc=1013,qi=1014,Yi=1015,Zi=1016,Zc=1017,Kc=1018,Or=1020,Ad=35902,Cd=35899,Rd=1021,Pd=1022,Ki=1023,Ps=1026,Us=1027,Ld=1028,jc=1029,ur=1030,Jc=1031;var Qc=1033,sl=33776,rl=33777,al=33778,ol=33779,eh=35840,th=35841,nh=35842,ih=35843,sh=36196,rh=37492,ah=37496,oh=37488,lh=37489,ll=37490,ch=37491,hh=37808,uh=37809,dh=37810,fh=37811,ph=37812,mh=37813,gh=37814,vh=37815,_h=37816,yh=37817,xh=37818,bh=37819,wh=37820,Sh=37821,Mh=36492,Eh=36494,Th=36495,Ah=36283,Ch=36284,cl=36285,Rh=36286;var Lo=2300,fc=2301,nc=2302,sd=2303,rd=2400,ad=2401,od=2402;var Mm=3200;var Ph=0,Em=1,Os="",_i="srgb",Io="srgb-linear",Do="linear",Nt="srgb";var ic=7680;var Tm=519,Am=512,Cm=513,Rm=514,Id=515,Pm=516,Lm=517,Dd=518,Nd=519,Im=35044;var kd="300 es",Di=2e3,Ca=2001;function l_(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function c_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function No(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Dm(){let i=No("canvas");return i.style.display="block",i}var Sp={},Ra=null;function Fd(...i){let e="THREE."+i.shift();Ra?Ra("log",e,...i):console.log(e,...i)}function Nm(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Je(...i){i=Nm(i);let e="THREE."+i.shift();if(Ra)Ra("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function ot(...i){i=Nm(i);let e="THREE."+i.shift();if(Ra)Ra("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function To(...i){let e=i.join(" ");e in Sp||(Sp[e]=!0,Je(...i))}function km(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Fm={[sc]:sc,[ac]:cc,[oc]:oc,[Aa]:lc,[rc]:rc,[cc]:ac,[hc]:hc,[lc]:Aa},Xi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}},Vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Mp=1234567,Ao=Math.PI/180,Pa=180/Math.PI;function Va(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Vn[i&255]+Vn[i>>8&255]+Vn[i>>16&255]+Vn[i>>24&255]+"-"+Vn[e&255]+Vn[e>>8&255]+"-"+Vn[e>>16&15|64]+Vn[e>>24&255]+"-"+Vn[t&63|128]+Vn[t>>8&255]+"-"+Vn[t>>16&255]+Vn[t>>24&255]+Vn[n&255]+Vn[n>>8&255]+Vn[n>>16&255]+Vn[n>>24&255]).toLowerCase()}function mt(i,e,t){return Math.max(e,Math.min(t,i))}function Ud(i,e){return(i%e+e)%e}function h_(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function u_(i,e,t){return i!==e?(t-i)/(e-i):0}function Co(i,e,t){return(1-t)*i+t*e}function d_(i,e,t,n){return Co(i,e,1-Math.exp(-t*n))}function f_(i,e=1){return e-Math.abs(Ud(i,e*2)-e)}function p_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function m_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function g_(i,e){return i+Math.floor(Math.random()*(e-i+1))}function v_(i,e){return i+Math.random()*(e-i)}function __(i){return i*(.5-Math.random())}function y_(i){i!==void 0&&(Mp=i);let e=Mp+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function x_(i){return i*Ao}function b_(i){return i*Pa}function w_(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function S_(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Od(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function M_(i,e,t,n,s){let r=Math.cos,a=Math.sin,o=r(t/2),l=a(t/2),c=r((e+n)/2),u=a((e+n)/2),d=r((e-n)/2),f=a((e-n)/2),p=r((n-e)/2),g=a((n-e)/2);switch(s){case"XYX":i.set(o*u,l*d,l*f,o*c);break;case"YZY":i.set(l*f,o*u,l*d,o*c);break;case"ZXZ":i.set(l*d,l*f,o*u,o*c);break;case"XZX":i.set(o*u,l*g,l*p,o*c);break;case"YXY":i.set(l*p,o*u,l*g,o*c);break;case"ZYZ":i.set(l*g,l*p,o*u,o*c);break;default:Je("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Bd(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Um(i,e){if(e.constructor===Float32Array)return i;let t=Bd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Om(i,e){if(e.constructor===Float32Array)return i;let t=Bd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var zd={DEG2RAD:Ao,RAD2DEG:Pa,generateUUID:Va,clamp:mt,euclideanModulo:Ud,mapLinear:h_,inverseLerp:u_,lerp:Co,damp:d_,pingpong:f_,smoothstep:p_,smootherstep:m_,randInt:g_,randFloat:v_,randFloatSpread:__,seededRandom:y_,degToRad:x_,radToDeg:b_,isPowerOfTwo:w_,ceilPowerOfTwo:S_,floorPowerOfTwo:Od,setQuaternionFromProperEuler:M_,normalize:Om,denormalize:Um},Ge=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(mt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*n-a*s+e.x,this.y=r*s+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Qn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,a,o){let l=n[s+0],c=n[s+1],u=n[s+2],d=n[s+3],f=r[a+0],p=r[a+1],g=r[a+2],_=r[a+3];if(d!==_||l!==f||c!==p||u!==g){let m=l*f+c*p+u*g+d*_;m<0&&(f=-f,p=-p,g=-g,_=-_,m=-m);let v=1-o;if(m<.9995){let x=Math.acos(m),S=Math.sin(x);v=Math.sin(v*x)/S,o=Math.sin(o*x)/S,l=l*v+f*o,c=c*v+p*o,u=u*v+g*o,d=d*v+_*o}else{l=l*v+f*o,c=c*v+p*o,u=u*v+g*o,d=d*v+_*o;let x=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=x,c*=x,u*=x,d*=x}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,s,r,a){let o=n[s],l=n[s+1],c=n[s+2],u=n[s+3],d=r[a],f=r[a+1],p=r[a+2],g=r[a+3];return e[t]=o*g+u*d+l*p-c*f,e[t+1]=l*g+u*f+c*d-o*p,e[t+2]=c*g+u*p+o*f-l*d,e[t+3]=u*g-o*d-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(n/2),u=o(s/2),d=o(r/2),f=l(n/2),p=l(s/2),g=l(r/2);switch(a){case"XYZ":this._x=f*u*d+c*p*g,this._y=c*p*d-f*u*g,this._z=c*u*g+f*p*d,this._w=c*u*d-f*p*g;break;case"YXZ":this._x=f*u*d+c*p*g,this._y=c*p*d-f*u*g,this._z=c*u*g-f*p*d,this._w=c*u*d+f*p*g;break;case"ZXY":this._x=f*u*d-c*p*g,this._y=c*p*d+f*u*g,this._z=c*u*g+f*p*d,this._w=c*u*d-f*p*g;break;case"ZYX":this._x=f*u*d-c*p*g,this._y=c*p*d+f*u*g,this._z=c*u*g-f*p*d,this._w=c*u*d+f*p*g;break;case"YZX":this._x=f*u*d+c*p*g,this._y=c*p*d+f*u*g,this._z=c*u*g-f*p*d,this._w=c*u*d-f*p*g;break;case"XZY":this._x=f*u*d-c*p*g,this._y=c*p*d-f*u*g,this._z=c*u*g+f*p*d,this._w=c*u*d+f*p*g;break;default:Je("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],u=t[6],d=t[10],f=n+o+d;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(a-s)*p}else if(n>o&&n>d){let p=2*Math.sqrt(1+n-o-d);this._w=(u-l)/p,this._x=.25*p,this._y=(s+a)/p,this._z=(r+c)/p}else if(o>d){let p=2*Math.sqrt(1+o-n-d);this._w=(r-c)/p,this._x=(s+a)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+d-n-o);this._w=(a-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(mt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+a*o+s*c-r*l,this._y=s*u+a*l+r*o-n*c,this._z=r*u+a*c+n*l-s*o,this._w=a*u-n*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){let c=Math.acos(o),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Ep.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Ep.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*n),u=2*(o*t-r*s),d=2*(r*n-a*t);return this.x=t+l*c+a*d-o*u,this.y=n+l*u+o*c-r*d,this.z=s+l*d+r*u-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-n*l,this.z=n*o-s*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Nu.copy(this).projectOnVector(e),this.sub(Nu)}reflect(e){return this.sub(Nu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(mt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Nu=new G,Ep=new Qn,lt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c)}set(e,t,n,s,r,a,o,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=o,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=a,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],u=n[4],d=n[7],f=n[2],p=n[5],g=n[8],_=s[0],m=s[3],v=s[6],x=s[1],S=s[4],y=s[7],T=s[2],M=s[5],b=s[8];return r[0]=a*_+o*x+l*T,r[3]=a*m+o*S+l*M,r[6]=a*v+o*y+l*b,r[1]=c*_+u*x+d*T,r[4]=c*m+u*S+d*M,r[7]=c*v+u*y+d*b,r[2]=f*_+p*x+g*T,r[5]=f*m+p*S+g*M,r[8]=f*v+p*y+g*b,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8];return t*a*u-t*o*c-n*r*u+n*o*l+s*r*c-s*a*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8],d=u*a-o*c,f=o*l-u*r,p=c*r-a*l,g=t*d+n*f+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/g;return e[0]=d*_,e[1]=(s*c-u*n)*_,e[2]=(o*n-s*a)*_,e[3]=f*_,e[4]=(u*t-s*l)*_,e[5]=(s*r-o*t)*_,e[6]=p*_,e[7]=(n*l-c*t)*_,e[8]=(a*t-n*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return To("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ku.makeScale(e,t)),this}rotate(e){return To("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ku.makeRotation(-e)),this}translate(e,t){return To("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ku.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},ku=new lt,Tp=new lt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Ap=new lt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function E_(){let i={enabled:!0,workingColorSpace:Io,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Nt&&(s.r=Rs(s.r),s.g=Rs(s.g),s.b=Rs(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Nt&&(s.r=Ta(s.r),s.g=Ta(s.g),s.b=Ta(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Os?Do:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Io]:{primaries:e,whitePoint:n,transfer:Do,toXYZ:Tp,fromXYZ:Ap,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:_i},outputColorSpaceConfig:{drawingBufferColorSpace:_i}},[_i]:{primaries:e,whitePoint:n,transfer:Nt,toXYZ:Tp,fromXYZ:Ap,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:_i}}}),i}var Mt=E_();function Rs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Ta(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var fa,pc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{fa===void 0&&(fa=No("canvas")),fa.width=e.width,fa.height=e.height;let s=fa.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=fa}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=No("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Rs(r[a]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Rs(t[n]/255)*255):t[n]=Rs(t[n]);return{data:t,width:e.width,height:e.height}}else return Je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},T_=0,La=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:T_++}),this.uuid=Va(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(Fu(s[a].image)):r.push(Fu(s[a]))}else r=Fu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Fu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?pc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Je("Texture: Unable to serialize Texture."),{})}var A_=0,Uu=new G,ri=class i extends Xi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=hs,s=hs,r=Jn,a=Fs,o=Ki,l=oi,c=i.DEFAULT_ANISOTROPY,u=Os){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:A_++}),this.uuid=Va(),this.name="",this.source=new La(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Ge(0,0),this.repeat=new Ge(1,1),this.center=new Ge(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new lt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Uu).x}get height(){return this.source.getSize(Uu).y}get depth(){return this.source.getSize(Uu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Md)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case uc:e.x=e.x-Math.floor(e.x);break;case hs:e.x=e.x<0?0:1;break;case dc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case uc:e.y=e.y-Math.floor(e.y);break;case hs:e.y=e.y<0?0:1;break;case dc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ri.DEFAULT_IMAGE=null;ri.DEFAULT_MAPPING=Md;ri.DEFAULT_ANISOTROPY=1;var tn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*n+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],d=l[8],f=l[1],p=l[5],g=l[9],_=l[2],m=l[6],v=l[10];if(Math.abs(u-f)<.01&&Math.abs(d-_)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(d+_)<.1&&Math.abs(g+m)<.1&&Math.abs(c+p+v-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let S=(c+1)/2,y=(p+1)/2,T=(v+1)/2,M=(u+f)/4,b=(d+_)/4,A=(g+m)/4;return S>y&&S>T?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=M/n,r=b/n):y>T?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=M/s,r=A/s):T<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),n=b/r,s=A/r),this.set(n,s,r,t),this}let x=Math.sqrt((m-g)*(m-g)+(d-_)*(d-_)+(f-u)*(f-u));return Math.abs(x)<.001&&(x=1),this.x=(m-g)/x,this.y=(d-_)/x,this.z=(f-u)/x,this.w=Math.acos((c+p+v-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this.w=mt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this.w=mt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},mc=class extends Xi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new tn(0,0,e,t),this.scissorTest=!1,this.viewport=new tn(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ri({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Jn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new La(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},bi=class extends mc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},ko=class extends ri{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Dn,this.minFilter=Dn,this.wrapR=hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var gc=class extends ri{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Dn,this.minFilter=Dn,this.wrapR=hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var $t=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,a,o,l,c,u,d,f,p,g,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c,u,d,f,p,g,_,m)}set(e,t,n,s,r,a,o,l,c,u,d,f,p,g,_,m){let v=this.elements;return v[0]=e,v[4]=t,v[8]=n,v[12]=s,v[1]=r,v[5]=a,v[9]=o,v[13]=l,v[2]=c,v[6]=u,v[10]=d,v[14]=f,v[3]=p,v[7]=g,v[11]=_,v[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/pa.setFromMatrixColumn(e,0).length(),r=1/pa.setFromMatrixColumn(e,1).length(),a=1/pa.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let f=a*u,p=a*d,g=o*u,_=o*d;t[0]=l*u,t[4]=-l*d,t[8]=c,t[1]=p+g*c,t[5]=f-_*c,t[9]=-o*l,t[2]=_-f*c,t[6]=g+p*c,t[10]=a*l}else if(e.order==="YXZ"){let f=l*u,p=l*d,g=c*u,_=c*d;t[0]=f+_*o,t[4]=g*o-p,t[8]=a*c,t[1]=a*d,t[5]=a*u,t[9]=-o,t[2]=p*o-g,t[6]=_+f*o,t[10]=a*l}else if(e.order==="ZXY"){let f=l*u,p=l*d,g=c*u,_=c*d;t[0]=f-_*o,t[4]=-a*d,t[8]=g+p*o,t[1]=p+g*o,t[5]=a*u,t[9]=_-f*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){let f=a*u,p=a*d,g=o*u,_=o*d;t[0]=l*u,t[4]=g*c-p,t[8]=f*c+_,t[1]=l*d,t[5]=_*c+f,t[9]=p*c-g,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){let f=a*l,p=a*c,g=o*l,_=o*c;t[0]=l*u,t[4]=_-f*d,t[8]=g*d+p,t[1]=d,t[5]=a*u,t[9]=-o*u,t[2]=-c*u,t[6]=p*d+g,t[10]=f-_*d}else if(e.order==="XZY"){let f=a*l,p=a*c,g=o*l,_=o*c;t[0]=l*u,t[4]=-d,t[8]=c*u,t[1]=f*d+_,t[5]=a*u,t[9]=p*d-g,t[2]=g*d-p,t[6]=o*u,t[10]=_*d+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(C_,e,R_)}lookAt(e,t,n){let s=this.elements;return gi.subVectors(e,t),gi.lengthSq()===0&&(gi.z=1),gi.normalize(),js.crossVectors(n,gi),js.lengthSq()===0&&(Math.abs(n.z)===1?gi.x+=1e-4:gi.z+=1e-4,gi.normalize(),js.crossVectors(n,gi)),js.normalize(),Nl.crossVectors(gi,js),s[0]=js.x,s[4]=Nl.x,s[8]=gi.x,s[1]=js.y,s[5]=Nl.y,s[9]=gi.y,s[2]=js.z,s[6]=Nl.z,s[10]=gi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],u=n[1],d=n[5],f=n[9],p=n[13],g=n[2],_=n[6],m=n[10],v=n[14],x=n[3],S=n[7],y=n[11],T=n[15],M=s[0],b=s[4],A=s[8],O=s[12],N=s[1],P=s[5],k=s[9],B=s[13],L=s[2],H=s[6],Y=s[10],$=s[14],ce=s[3],K=s[7],ee=s[11],ne=s[15];return r[0]=a*M+o*N+l*L+c*ce,r[4]=a*b+o*P+l*H+c*K,r[8]=a*A+o*k+l*Y+c*ee,r[12]=a*O+o*B+l*$+c*ne,r[1]=u*M+d*N+f*L+p*ce,r[5]=u*b+d*P+f*H+p*K,r[9]=u*A+d*k+f*Y+p*ee,r[13]=u*O+d*B+f*$+p*ne,r[2]=g*M+_*N+m*L+v*ce,r[6]=g*b+_*P+m*H+v*K,r[10]=g*A+_*k+m*Y+v*ee,r[14]=g*O+_*B+m*$+v*ne,r[3]=x*M+S*N+y*L+T*ce,r[7]=x*b+S*P+y*H+T*K,r[11]=x*A+S*k+y*Y+T*ee,r[15]=x*O+S*B+y*$+T*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],u=e[2],d=e[6],f=e[10],p=e[14],g=e[3],_=e[7],m=e[11],v=e[15],x=l*p-c*f,S=o*p-c*d,y=o*f-l*d,T=a*p-c*u,M=a*f-l*u,b=a*d-o*u;return t*(_*x-m*S+v*y)-n*(g*x-m*T+v*M)+s*(g*S-_*T+v*b)-r*(g*y-_*M+m*b)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],u=e[10];return t*(a*u-o*c)-n*(r*u-o*l)+s*(r*c-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8],d=e[9],f=e[10],p=e[11],g=e[12],_=e[13],m=e[14],v=e[15],x=t*o-n*a,S=t*l-s*a,y=t*c-r*a,T=n*l-s*o,M=n*c-r*o,b=s*c-r*l,A=u*_-d*g,O=u*m-f*g,N=u*v-p*g,P=d*m-f*_,k=d*v-p*_,B=f*v-p*m,L=x*B-S*k+y*P+T*N-M*O+b*A;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/L;return e[0]=(o*B-l*k+c*P)*H,e[1]=(s*k-n*B-r*P)*H,e[2]=(_*b-m*M+v*T)*H,e[3]=(f*M-d*b-p*T)*H,e[4]=(l*N-a*B-c*O)*H,e[5]=(t*B-s*N+r*O)*H,e[6]=(m*y-g*b-v*S)*H,e[7]=(u*b-f*y+p*S)*H,e[8]=(a*k-o*N+c*A)*H,e[9]=(n*N-t*k-r*A)*H,e[10]=(g*M-_*y+v*x)*H,e[11]=(d*y-u*M-p*x)*H,e[12]=(o*O-a*P-l*A)*H,e[13]=(t*P-n*O+s*A)*H,e[14]=(_*S-g*T-m*x)*H,e[15]=(u*T-d*S+f*x)*H,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,a=e.x,o=e.y,l=e.z,c=r*a,u=r*o;return this.set(c*a+n,c*o-s*l,c*l+s*o,0,c*o+s*l,u*o+n,u*l-s*a,0,c*l-s*o,u*l+s*a,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,a){return this.set(1,n,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,u=a+a,d=o+o,f=r*c,p=r*u,g=r*d,_=a*u,m=a*d,v=o*d,x=l*c,S=l*u,y=l*d,T=n.x,M=n.y,b=n.z;return s[0]=(1-(_+v))*T,s[1]=(p+y)*T,s[2]=(g-S)*T,s[3]=0,s[4]=(p-y)*M,s[5]=(1-(f+v))*M,s[6]=(m+x)*M,s[7]=0,s[8]=(g+S)*b,s[9]=(m-x)*b,s[10]=(1-(f+_))*b,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let a=pa.set(s[0],s[1],s[2]).length(),o=pa.set(s[4],s[5],s[6]).length(),l=pa.set(s[8],s[9],s[10]).length();r<0&&(a=-a),Hi.copy(this);let c=1/a,u=1/o,d=1/l;return Hi.elements[0]*=c,Hi.elements[1]*=c,Hi.elements[2]*=c,Hi.elements[4]*=u,Hi.elements[5]*=u,Hi.elements[6]*=u,Hi.elements[8]*=d,Hi.elements[9]*=d,Hi.elements[10]*=d,t.setFromRotationMatrix(Hi),n.x=a,n.y=o,n.z=l,this}makePerspective(e,t,n,s,r,a,o=Di,l=!1){let c=this.elements,u=2*r/(t-e),d=2*r/(n-s),f=(t+e)/(t-e),p=(n+s)/(n-s),g,_;if(l)g=r/(a-r),_=a*r/(a-r);else if(o===Di)g=-(a+r)/(a-r),_=-2*a*r/(a-r);else if(o===Ca)g=-a/(a-r),_=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=d,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,a,o=Di,l=!1){let c=this.elements,u=2/(t-e),d=2/(n-s),f=-(t+e)/(t-e),p=-(n+s)/(n-s),g,_;if(l)g=1/(a-r),_=a/(a-r);else if(o===Di)g=-2/(a-r),_=-(a+r)/(a-r);else if(o===Ca)g=-1/(a-r),_=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=d,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},pa=new G,Hi=new $t,C_=new G(0,0,0),R_=new G(1,1,1),js=new G,Nl=new G,gi=new G,Cp=new $t,Rp=new Qn,Ls=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],u=s[9],d=s[2],f=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(mt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-mt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(o,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(mt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-d,p),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-mt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(mt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(o,p));break;case"XZY":this._z=Math.asin(-mt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Cp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Cp,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Rp.setFromEuler(this),this.setFromQuaternion(Rp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ls.DEFAULT_ORDER="XYZ";var Fo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},P_=0,Pp=new G,ma=new Qn,Ms=new $t,kl=new G,bo=new G,L_=new G,I_=new Qn,Lp=new G(1,0,0),Ip=new G(0,1,0),Dp=new G(0,0,1),Np={type:"added"},D_={type:"removed"},ga={type:"childadded",child:null},Ou={type:"childremoved",child:null},Hn=class i extends Xi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:P_++}),this.uuid=Va(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new G,t=new Ls,n=new Qn,s=new G(1,1,1);function r(){n.setFromEuler(t,!1)}function a(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new $t},normalMatrix:{value:new lt}}),this.matrix=new $t,this.matrixWorld=new $t,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Fo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ma.setFromAxisAngle(e,t),this.quaternion.multiply(ma),this}rotateOnWorldAxis(e,t){return ma.setFromAxisAngle(e,t),this.quaternion.premultiply(ma),this}rotateX(e){return this.rotateOnAxis(Lp,e)}rotateY(e){return this.rotateOnAxis(Ip,e)}rotateZ(e){return this.rotateOnAxis(Dp,e)}translateOnAxis(e,t){return Pp.copy(e).applyQuaternion(this.quaternion),this.position.add(Pp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Lp,e)}translateY(e){return this.translateOnAxis(Ip,e)}translateZ(e){return this.translateOnAxis(Dp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ms.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?kl.copy(e):kl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),bo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ms.lookAt(bo,kl,this.up):Ms.lookAt(kl,bo,this.up),this.quaternion.setFromRotationMatrix(Ms),s&&(Ms.extractRotation(s.matrixWorld),ma.setFromRotationMatrix(Ms),this.quaternion.premultiply(ma.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ot("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Np),ga.child=e,this.dispatchEvent(ga),ga.child=null):ot("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(D_),Ou.child=e,this.dispatchEvent(Ou),Ou.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ms.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ms.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ms),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Np),ga.child=e,this.dispatchEvent(ga),ga.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(bo,e,L_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(bo,I_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){let o=a(e.geometries),l=a(e.materials),c=a(e.textures),u=a(e.images),d=a(e.shapes),f=a(e.skeletons),p=a(e.animations),g=a(e.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),d.length>0&&(n.shapes=d),f.length>0&&(n.skeletons=f),p.length>0&&(n.animations=p),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let l=[];for(let c in o){let u=o[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Hn.DEFAULT_UP=new G(0,1,0);Hn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Hn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Fn=class extends Hn{constructor(){super(),this.isGroup=!0,this.type="Group"}},N_={type:"move"},Ia=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Fn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Fn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Fn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(let _ of e.hand.values()){let m=t.getJointPose(_,n),v=this._getHandJoint(c,_);m!==null&&(v.matrix.fromArray(m.transform.matrix),v.matrix.decompose(v.position,v.quaternion,v.scale),v.matrixWorldNeedsUpdate=!0,v.jointRadius=m.radius),v.visible=m!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],f=u.position.distanceTo(d.position),p=.02,g=.005;c.inputState.pinching&&f>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(N_)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Fn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Bm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Js={h:0,s:0,l:0},Fl={h:0,s:0,l:0};function Bu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Qe=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=_i){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Mt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Mt.workingColorSpace){return this.r=e,this.g=t,this.b=n,Mt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Mt.workingColorSpace){if(e=Ud(e,1),t=mt(t,0,1),n=mt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,a=2*n-r;this.r=Bu(a,r,e+1/3),this.g=Bu(a,r,e),this.b=Bu(a,r,e-1/3)}return Mt.colorSpaceToWorking(this,s),this}setStyle(e,t=_i){function n(r){r!==void 0&&parseFloat(r)<1&&Je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);Je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=_i){let n=Bm[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Rs(e.r),this.g=Rs(e.g),this.b=Rs(e.b),this}copyLinearToSRGB(e){return this.r=Ta(e.r),this.g=Ta(e.g),this.b=Ta(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=_i){return Mt.workingToColorSpace(Gn.copy(this),e),Math.round(mt(Gn.r*255,0,255))*65536+Math.round(mt(Gn.g*255,0,255))*256+Math.round(mt(Gn.b*255,0,255))}getHexString(e=_i){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Mt.workingColorSpace){Mt.workingToColorSpace(Gn.copy(this),t);let n=Gn.r,s=Gn.g,r=Gn.b,a=Math.max(n,s,r),o=Math.min(n,s,r),l,c,u=(o+a)/2;if(o===a)l=0,c=0;else{let d=a-o;switch(c=u<=.5?d/(a+o):d/(2-a-o),a){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=Mt.workingColorSpace){return Mt.workingToColorSpace(Gn.copy(this),t),e.r=Gn.r,e.g=Gn.g,e.b=Gn.b,e}getStyle(e=_i){Mt.workingToColorSpace(Gn.copy(this),e);let t=Gn.r,n=Gn.g,s=Gn.b;return e!==_i?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Js),this.setHSL(Js.h+e,Js.s+t,Js.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Js),e.getHSL(Fl);let n=Co(Js.h,Fl.h,t),s=Co(Js.s,Fl.s,t),r=Co(Js.l,Fl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Gn=new Qe;Qe.NAMES=Bm;var Uo=class extends Hn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ls,this.environmentIntensity=1,this.environmentRotation=new Ls,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Wi=new G,Es=new G,zu=new G,Ts=new G,va=new G,_a=new G,kp=new G,Vu=new G,Gu=new G,Hu=new G,Wu=new tn,$u=new tn,Xu=new tn,nr=class i{constructor(e=new G,t=new G,n=new G){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Wi.subVectors(e,t),s.cross(Wi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Wi.subVectors(s,t),Es.subVectors(n,t),zu.subVectors(e,t);let a=Wi.dot(Wi),o=Wi.dot(Es),l=Wi.dot(zu),c=Es.dot(Es),u=Es.dot(zu),d=a*c-o*o;if(d===0)return r.set(0,0,0),null;let f=1/d,p=(c*l-o*u)*f,g=(a*u-o*l)*f;return r.set(1-p-g,g,p)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ts)===null?!1:Ts.x>=0&&Ts.y>=0&&Ts.x+Ts.y<=1}static getInterpolation(e,t,n,s,r,a,o,l){return this.getBarycoord(e,t,n,s,Ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ts.x),l.addScaledVector(a,Ts.y),l.addScaledVector(o,Ts.z),l)}static getInterpolatedAttribute(e,t,n,s,r,a){return Wu.setScalar(0),$u.setScalar(0),Xu.setScalar(0),Wu.fromBufferAttribute(e,t),$u.fromBufferAttribute(e,n),Xu.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(Wu,r.x),a.addScaledVector($u,r.y),a.addScaledVector(Xu,r.z),a}static isFrontFacing(e,t,n,s){return Wi.subVectors(n,t),Es.subVectors(e,t),Wi.cross(Es).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Wi.subVectors(this.c,this.b),Es.subVectors(this.a,this.b),Wi.cross(Es).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,a,o;va.subVectors(s,n),_a.subVectors(r,n),Vu.subVectors(e,n);let l=va.dot(Vu),c=_a.dot(Vu);if(l<=0&&c<=0)return t.copy(n);Gu.subVectors(e,s);let u=va.dot(Gu),d=_a.dot(Gu);if(u>=0&&d<=u)return t.copy(s);let f=l*d-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return a=l/(l-u),t.copy(n).addScaledVector(va,a);Hu.subVectors(e,r);let p=va.dot(Hu),g=_a.dot(Hu);if(g>=0&&p<=g)return t.copy(r);let _=p*c-l*g;if(_<=0&&c>=0&&g<=0)return o=c/(c-g),t.copy(n).addScaledVector(_a,o);let m=u*g-p*d;if(m<=0&&d-u>=0&&p-g>=0)return kp.subVectors(r,s),o=(d-u)/(d-u+(p-g)),t.copy(s).addScaledVector(kp,o);let v=1/(m+_+f);return a=_*v,o=f*v,t.copy(n).addScaledVector(va,a).addScaledVector(_a,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ir=class{constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint($i.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint($i.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=$i.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,$i):$i.fromBufferAttribute(r,a),$i.applyMatrix4(e.matrixWorld),this.expandByPoint($i);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ul.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ul.copy(n.boundingBox)),Ul.applyMatrix4(e.matrixWorld),this.union(Ul)}let s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,$i),$i.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(wo),Ol.subVectors(this.max,wo),ya.subVectors(e.a,wo),xa.subVectors(e.b,wo),ba.subVectors(e.c,wo),Qs.subVectors(xa,ya),er.subVectors(ba,xa),Ar.subVectors(ya,ba);let t=[0,-Qs.z,Qs.y,0,-er.z,er.y,0,-Ar.z,Ar.y,Qs.z,0,-Qs.x,er.z,0,-er.x,Ar.z,0,-Ar.x,-Qs.y,Qs.x,0,-er.y,er.x,0,-Ar.y,Ar.x,0];return!qu(t,ya,xa,ba,Ol)||(t=[1,0,0,0,1,0,0,0,1],!qu(t,ya,xa,ba,Ol))?!1:(Bl.crossVectors(Qs,er),t=[Bl.x,Bl.y,Bl.z],qu(t,ya,xa,ba,Ol))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,$i).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize($i).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(As[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),As[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),As[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),As[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),As[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),As[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),As[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),As[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(As),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},As=[new G,new G,new G,new G,new G,new G,new G,new G],$i=new G,Ul=new ir,ya=new G,xa=new G,ba=new G,Qs=new G,er=new G,Ar=new G,wo=new G,Ol=new G,Bl=new G,Cr=new G;function qu(i,e,t,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){Cr.fromArray(i,r);let o=s.x*Math.abs(Cr.x)+s.y*Math.abs(Cr.y)+s.z*Math.abs(Cr.z),l=e.dot(Cr),c=t.dot(Cr),u=n.dot(Cr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>o)return!1}return!0}var yn=new G,zl=new Ge,k_=0,si=class extends Xi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:k_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Im,this.updateRanges=[],this.gpuType=Yi,this.version=0,this._normalizationScale=e!==void 0?Bd(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)zl.fromBufferAttribute(this,t),zl.applyMatrix3(e),this.setXY(t,zl.x,zl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix3(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix4(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.applyNormalMatrix(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.transformDirection(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Um(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Om(e,this.array)}};var Oo=class extends si{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Bo=class extends si{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Xt=class extends si{constructor(e,t,n){super(new Float32Array(e),t,n)}},F_=new ir,So=new G,Yu=new G,Lr=class{constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):F_.setFromPoints(e).getCenter(n);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;So.subVectors(e,this.center);let t=So.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(So,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Yu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(So.copy(e.center).add(Yu)),this.expandByPoint(So.copy(e.center).sub(Yu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},U_=0,Ii=new $t,Zu=new Hn,wa=new G,vi=new ir,Mo=new ir,In=new G,fn=class i extends Xi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:U_++}),this.uuid=Va(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(l_(e)?Bo:Oo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new lt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ii.makeRotationFromQuaternion(e),this.applyMatrix4(Ii),this}rotateX(e){return Ii.makeRotationX(e),this.applyMatrix4(Ii),this}rotateY(e){return Ii.makeRotationY(e),this.applyMatrix4(Ii),this}rotateZ(e){return Ii.makeRotationZ(e),this.applyMatrix4(Ii),this}translate(e,t,n){return Ii.makeTranslation(e,t,n),this.applyMatrix4(Ii),this}scale(e,t,n){return Ii.makeScale(e,t,n),this.applyMatrix4(Ii),this}lookAt(e){return Zu.lookAt(e),Zu.updateMatrix(),this.applyMatrix4(Zu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(wa).negate(),this.translate(wa.x,wa.y,wa.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let a=e[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new Xt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ir);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ot("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];vi.setFromBufferAttribute(r),this.morphTargetsRelative?(In.addVectors(this.boundingBox.min,vi.min),this.boundingBox.expandByPoint(In),In.addVectors(this.boundingBox.max,vi.max),this.boundingBox.expandByPoint(In)):(this.boundingBox.expandByPoint(vi.min),this.boundingBox.expandByPoint(vi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ot('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Lr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ot("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(e){let n=this.boundingSphere.center;if(vi.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){let o=t[r];Mo.setFromBufferAttribute(o),this.morphTargetsRelative?(In.addVectors(vi.min,Mo.min),vi.expandByPoint(In),In.addVectors(vi.max,Mo.max),vi.expandByPoint(In)):(vi.expandByPoint(Mo.min),vi.expandByPoint(Mo.max))}vi.getCenter(n);let s=0;for(let r=0,a=e.count;r<a;r++)In.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(In));if(t)for(let r=0,a=t.length;r<a;r++){let o=t[r],l=this.morphTargetsRelative;for(let c=0,u=o.count;c<u;c++)In.fromBufferAttribute(o,c),l&&(wa.fromBufferAttribute(e,c),In.add(wa)),s=Math.max(s,n.distanceToSquared(In))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ot('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ot("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new si(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(n.count);for(let O=0;O<n.count;O++)o[O]=new G,l[O]=new G;let u=new G,d=new G,f=new G,p=new Ge,g=new Ge,_=new Ge,m=new G,v=new G;function x(O,N,P){c[O]=c[N]=c[P]=1,u.fromBufferAttribute(n,O),d.fromBufferAttribute(n,N),f.fromBufferAttribute(n,P),p.fromBufferAttribute(r,O),g.fromBufferAttribute(r,N),_.fromBufferAttribute(r,P),d.sub(u),f.sub(u),g.sub(p),_.sub(p);let k=1/(g.x*_.y-_.x*g.y);isFinite(k)&&(m.copy(d).multiplyScalar(_.y).addScaledVector(f,-g.y).multiplyScalar(k),v.copy(f).multiplyScalar(g.x).addScaledVector(d,-_.x).multiplyScalar(k),o[O].add(m),o[N].add(m),o[P].add(m),l[O].add(v),l[N].add(v),l[P].add(v))}let S=this.groups;S.length===0&&(S=[{start:0,count:e.count}]);for(let O=0,N=S.length;O<N;++O){let P=S[O],k=P.start,B=P.count;for(let L=k,H=k+B;L<H;L+=3)x(e.getX(L+0),e.getX(L+1),e.getX(L+2))}let y=new G,T=new G,M=new G,b=new G;function A(O){M.fromBufferAttribute(s,O),b.copy(M);let N=o[O];y.copy(N),y.sub(M.multiplyScalar(M.dot(N))).normalize(),T.crossVectors(b,N);let k=T.dot(l[O])<0?-1:1;a.setXYZW(O,y.x,y.y,y.z,k)}for(let O=0,N=n.count;O<N;++O)c[O]&&A(O);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new si(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,p=n.count;f<p;f++)n.setXYZ(f,0,0,0);let s=new G,r=new G,a=new G,o=new G,l=new G,c=new G,u=new G,d=new G;if(e)for(let f=0,p=e.count;f<p;f+=3){let g=e.getX(f+0),_=e.getX(f+1),m=e.getX(f+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,_),a.fromBufferAttribute(t,m),u.subVectors(a,r),d.subVectors(s,r),u.cross(d),o.fromBufferAttribute(n,g),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,m),o.add(u),l.add(u),c.add(u),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),a.fromBufferAttribute(t,f+2),u.subVectors(a,r),d.subVectors(s,r),u.cross(d),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)In.fromBufferAttribute(e,t),In.normalize(),e.setXYZ(t,In.x,In.y,In.z)}toNonIndexed(){function e(o,l){let c=o.array,u=o.itemSize,d=o.normalized,f=new c.constructor(l.length*u),p=0,g=0;for(let _=0,m=l.length;_<m;_++){o.isInterleavedBufferAttribute?p=l[_]*o.data.stride+o.offset:p=l[_]*u;for(let v=0;v<u;v++)f[g++]=c[p++]}return new si(f,u,d)}if(this.index===null)return Je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=e(l,n);t.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let u=0,d=c.length;u<d;u++){let f=c[u],p=e(f,n);l.push(p)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,f=c.length;d<f;d++){let p=c[d];u.push(p.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],d=r[c];for(let f=0,p=d.length;f<p;f++)u.push(d[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let c=0,u=a.length;c<u;c++){let d=a[c];this.addGroup(d.start,d.count,d.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ku=new G,O_=new G,B_=new lt,yi=class{constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Ku.subVectors(n,t).cross(O_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Ku),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||B_.getNormalMatrix(e),s=this.coplanarPoint(Ku).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},z_=0,Is=class extends Xi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:z_++}),this.uuid=Va(),this.name="",this.type="Material",this.blending=Oa,this.side=hr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=md,this.blendDst=gd,this.blendEquation=Fr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Qe(0,0,0),this.blendAlpha=0,this.depthFunc=Aa,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Tm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ic,this.stencilZFail=ic,this.stencilZPass=ic,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(t){let r=s(e.textures),a=s(e.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Qe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new yi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ge().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ge().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Cs=new G,ju=new G,Vl=new G,Gl=new G,Ir=class{constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Cs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Cs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Cs.copy(this.origin).addScaledVector(this.direction,t),Cs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){ju.copy(e).add(t).multiplyScalar(.5),Vl.copy(t).sub(e).normalize(),Gl.copy(this.origin).sub(ju);let r=e.distanceTo(t)*.5,a=-this.direction.dot(Vl),o=Gl.dot(this.direction),l=-Gl.dot(Vl),c=Gl.lengthSq(),u=Math.abs(1-a*a),d,f,p,g;if(u>0)if(d=a*l-o,f=a*o-l,g=r*u,d>=0)if(f>=-g)if(f<=g){let _=1/u;d*=_,f*=_,p=d*(d+a*f+2*o)+f*(a*d+f+2*l)+c}else f=r,d=Math.max(0,-(a*f+o)),p=-d*d+f*(f+2*l)+c;else f=-r,d=Math.max(0,-(a*f+o)),p=-d*d+f*(f+2*l)+c;else f<=-g?(d=Math.max(0,-(-a*r+o)),f=d>0?-r:Math.min(Math.max(-r,-l),r),p=-d*d+f*(f+2*l)+c):f<=g?(d=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(d=Math.max(0,-(a*r+o)),f=d>0?r:Math.min(Math.max(-r,-l),r),p=-d*d+f*(f+2*l)+c);else f=a>0?-r:r,d=Math.max(0,-(a*f+o)),p=-d*d+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(ju).addScaledVector(Vl,f),p}intersectSphere(e,t){if(e.radius<0)return null;Cs.subVectors(e.center,this.origin);let n=Cs.dot(this.direction),s=Cs.dot(Cs)-n*n,r=e.radius*e.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,a,o,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,a=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,a=(e.min.y-f.y)*u),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),d>=0?(o=(e.min.z-f.z)*d,l=(e.max.z-f.z)*d):(o=(e.max.z-f.z)*d,l=(e.min.z-f.z)*d),n>l||o>s)||((o>n||n!==n)&&(n=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Cs)!==null}intersectTriangle(e,t,n,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,u=o.z,d=e.x-a.x,f=e.y-a.y,p=e.z-a.z,g=t.x-a.x,_=t.y-a.y,m=t.z-a.z,v=n.x-a.x,x=n.y-a.y,S=n.z-a.z,y=Math.abs(l),T=Math.abs(c),M=Math.abs(u),b,A,O,N,P,k,B,L,H,Y,$,ce;if(y>=T&&y>=M?(O=l,k=d,H=g,ce=v,l>=0?(b=c,A=u,N=f,P=p,B=_,L=m,Y=x,$=S):(b=u,A=c,N=p,P=f,B=m,L=_,Y=S,$=x)):T>=M?(O=c,k=f,H=_,ce=x,c>=0?(b=u,A=l,N=p,P=d,B=m,L=g,Y=S,$=v):(b=l,A=u,N=d,P=p,B=g,L=m,Y=v,$=S)):(O=u,k=p,H=m,ce=S,u>=0?(b=l,A=c,N=d,P=f,B=g,L=_,Y=v,$=x):(b=c,A=l,N=f,P=d,B=_,L=g,Y=x,$=v)),O===0)return null;let K=b/O,ee=A/O,ne=1/O,ue=N-K*k,de=P-ee*k,Q=B-K*H,ge=L-ee*H,ye=Y-K*ce,Te=$-ee*ce,be=ye*ge-Te*Q,Ye=ue*Te-de*ye,he=Q*de-ge*ue;if(s){if(be<0||Ye<0||he<0)return null}else if((be<0||Ye<0||he<0)&&(be>0||Ye>0||he>0))return null;let Ie=be+Ye+he;if(Ie===0)return null;let rt=ne*(be*k+Ye*H+he*ce);return(Ie>0?rt<0:rt>0)?null:this.at(rt/Ie,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},vc=class extends Is{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ls,this.combine=Wc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Fp=new $t,Rr=new Ir,Hl=new Lr,Up=new G,Wl=new G,$l=new G,Xl=new G,Ju=new G,ql=new G,Op=new G,Yl=new G,hn=class extends Hn{constructor(e=new fn,t=new vc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let o=this.morphTargetInfluences;if(r&&o){ql.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=o[l],d=r[l];u!==0&&(Ju.fromBufferAttribute(d,e),a?ql.addScaledVector(Ju,u):ql.addScaledVector(Ju.sub(t),u))}t.add(ql)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Hl.copy(n.boundingSphere),Hl.applyMatrix4(r),Rr.copy(e.ray).recast(e.near),!(Hl.containsPoint(Rr.origin)===!1&&(Rr.intersectSphere(Hl,Up)===null||Rr.origin.distanceToSquared(Up)>(e.far-e.near)**2))&&(Fp.copy(r).invert(),Rr.copy(e.ray).applyMatrix4(Fp),!(n.boundingBox!==null&&Rr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Rr)))}_computeIntersections(e,t,n){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,f=r.groups,p=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,_=f.length;g<_;g++){let m=f[g],v=a[m.materialIndex],x=Math.max(m.start,p.start),S=Math.min(o.count,Math.min(m.start+m.count,p.start+p.count));for(let y=x,T=S;y<T;y+=3){let M=o.getX(y),b=o.getX(y+1),A=o.getX(y+2);s=Zl(this,v,e,n,c,u,d,M,b,A),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),_=Math.min(o.count,p.start+p.count);for(let m=g,v=_;m<v;m+=3){let x=o.getX(m),S=o.getX(m+1),y=o.getX(m+2);s=Zl(this,a,e,n,c,u,d,x,S,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let g=0,_=f.length;g<_;g++){let m=f[g],v=a[m.materialIndex],x=Math.max(m.start,p.start),S=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let y=x,T=S;y<T;y+=3){let M=y,b=y+1,A=y+2;s=Zl(this,v,e,n,c,u,d,M,b,A),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),_=Math.min(l.count,p.start+p.count);for(let m=g,v=_;m<v;m+=3){let x=m,S=m+1,y=m+2;s=Zl(this,a,e,n,c,u,d,x,S,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function V_(i,e,t,n,s,r,a,o){let l;if(e.side===ti?l=n.intersectTriangle(a,r,s,!0,o):l=n.intersectTriangle(s,r,a,e.side===hr,o),l===null)return null;Yl.copy(o),Yl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Yl);return c<t.near||c>t.far?null:{distance:c,point:Yl.clone(),object:i}}function Zl(i,e,t,n,s,r,a,o,l,c){i.getVertexPosition(o,Wl),i.getVertexPosition(l,$l),i.getVertexPosition(c,Xl);let u=V_(i,e,t,n,Wl,$l,Xl,Op);if(u){let d=new G;nr.getBarycoord(Op,Wl,$l,Xl,d),s&&(u.uv=nr.getInterpolatedAttribute(s,o,l,c,d,new Ge)),r&&(u.uv1=nr.getInterpolatedAttribute(r,o,l,c,d,new Ge)),a&&(u.normal=nr.getInterpolatedAttribute(a,o,l,c,d,new G),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a:o,b:l,c,normal:new G,materialIndex:0};nr.getNormal(Wl,$l,Xl,f.normal),u.face=f,u.barycoord=d}return u}var _c=class extends ri{constructor(e=null,t=1,n=1,s,r,a,o,l,c=Dn,u=Dn,d,f){super(null,a,o,l,c,u,s,r,d,f),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Pr=new Lr,G_=new Ge(.5,.5),Kl=new G,sr=class{constructor(e=new yi,t=new yi,n=new yi,s=new yi,r=new yi,a=new yi){this.planes=[e,t,n,s,r,a]}set(e,t,n,s,r,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Di,n=!1){let s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],u=r[4],d=r[5],f=r[6],p=r[7],g=r[8],_=r[9],m=r[10],v=r[11],x=r[12],S=r[13],y=r[14],T=r[15];if(s[0].setComponents(c-a,p-u,v-g,T-x).normalize(),s[1].setComponents(c+a,p+u,v+g,T+x).normalize(),s[2].setComponents(c+o,p+d,v+_,T+S).normalize(),s[3].setComponents(c-o,p-d,v-_,T-S).normalize(),n)s[4].setComponents(l,f,m,y).normalize(),s[5].setComponents(c-l,p-f,v-m,T-y).normalize();else if(s[4].setComponents(c-l,p-f,v-m,T-y).normalize(),t===Di)s[5].setComponents(c+l,p+f,v+m,T+y).normalize();else if(t===Ca)s[5].setComponents(l,f,m,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Pr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Pr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Pr)}intersectsSprite(e){Pr.center.set(0,0,0);let t=G_.distanceTo(e.center);return Pr.radius=.7071067811865476+t,Pr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Pr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Kl.x=s.normal.x>0?e.max.x:e.min.x,Kl.y=s.normal.y>0?e.max.y:e.min.y,Kl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Kl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Bp=new $t,yc=class i{constructor(){this.coordinateSystem=Di,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Bp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new sr),n[s].setFromProjectionMatrix(Bp,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new sr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Ds=class extends Is{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Qe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},xc=new G,bc=new G,zp=new $t,Eo=new Ir,jl=new Lr,Qu=new G,Vp=new G,us=class extends Hn{constructor(e=new fn,t=new Ds){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)xc.fromBufferAttribute(t,s-1),bc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=xc.distanceTo(bc);e.setAttribute("lineDistance",new Xt(n,1))}else Je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),jl.copy(n.boundingSphere),jl.applyMatrix4(s),jl.radius+=r,e.ray.intersectsSphere(jl)===!1)return;zp.copy(s).invert(),Eo.copy(e.ray).applyMatrix4(zp);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let p=Math.max(0,a.start),g=Math.min(u.count,a.start+a.count);for(let _=p,m=g-1;_<m;_+=c){let v=u.getX(_),x=u.getX(_+1),S=Jl(this,e,Eo,l,v,x,_);S&&t.push(S)}if(this.isLineLoop){let _=u.getX(g-1),m=u.getX(p),v=Jl(this,e,Eo,l,_,m,g-1);v&&t.push(v)}}else{let p=Math.max(0,a.start),g=Math.min(f.count,a.start+a.count);for(let _=p,m=g-1;_<m;_+=c){let v=Jl(this,e,Eo,l,_,_+1,_);v&&t.push(v)}if(this.isLineLoop){let _=Jl(this,e,Eo,l,g-1,p,g-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function Jl(i,e,t,n,s,r,a){let o=i.geometry.attributes.position;if(xc.fromBufferAttribute(o,s),bc.fromBufferAttribute(o,r),t.distanceSqToSegment(xc,bc,Qu,Vp)>n)return;Qu.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Qu);if(!(c<e.near||c>e.far))return{distance:c,point:Vp.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var Gp=new G,Hp=new G,zo=class extends us{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Gp.fromBufferAttribute(t,s),Hp.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Gp.distanceTo(Hp);e.setAttribute("lineDistance",new Xt(n,1))}else Je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Vo=class extends ri{constructor(e=[],t=Ur,n,s,r,a,o,l,c,u){super(e,t,n,s,r,a,o,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ns=class extends ri{constructor(e,t,n=qi,s,r,a,o=Dn,l=Dn,c,u=Ps,d=1){if(u!==Ps&&u!==Us)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:d};super(f,s,r,a,o,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new La(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Go=class extends Ns{constructor(e,t=qi,n=Ur,s,r,a=Dn,o=Dn,l,c=Ps){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,n,s,r,a,o,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ho=class extends ri{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ks=class i extends fn{constructor(e=1,t=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],u=[],d=[],f=0,p=0;g("z","y","x",-1,-1,n,t,e,a,r,0),g("z","y","x",1,-1,n,t,-e,a,r,1),g("x","z","y",1,1,e,n,t,s,a,2),g("x","z","y",1,-1,e,n,-t,s,a,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Xt(c,3)),this.setAttribute("normal",new Xt(u,3)),this.setAttribute("uv",new Xt(d,2));function g(_,m,v,x,S,y,T,M,b,A,O){let N=y/b,P=T/A,k=y/2,B=T/2,L=M/2,H=b+1,Y=A+1,$=0,ce=0,K=new G;for(let ee=0;ee<Y;ee++){let ne=ee*P-B;for(let ue=0;ue<H;ue++){let de=ue*N-k;K[_]=de*x,K[m]=ne*S,K[v]=L,c.push(K.x,K.y,K.z),K[_]=0,K[m]=0,K[v]=M>0?1:-1,u.push(K.x,K.y,K.z),d.push(ue/b),d.push(1-ee/A),$+=1}}for(let ee=0;ee<A;ee++)for(let ne=0;ne<b;ne++){let ue=f+ne+H*ee,de=f+ne+H*(ee+1),Q=f+(ne+1)+H*(ee+1),ge=f+(ne+1)+H*ee;l.push(ue,de,ge),l.push(de,Q,ge),ce+=6}o.addGroup(p,ce,O),p+=ce,f+=$}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Da=class i extends fn{constructor(e=1,t=1,n=1,s=32,r=1,a=!1,o=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],f=[],p=[],g=0,_=[],m=n/2,v=0;x(),a===!1&&(e>0&&S(!0),t>0&&S(!1)),this.setIndex(u),this.setAttribute("position",new Xt(d,3)),this.setAttribute("normal",new Xt(f,3)),this.setAttribute("uv",new Xt(p,2));function x(){let y=new G,T=new G,M=0,b=(t-e)/n;for(let A=0;A<=r;A++){let O=[],N=A/r,P=N*(t-e)+e;for(let k=0;k<=s;k++){let B=k/s,L=B*l+o,H=Math.sin(L),Y=Math.cos(L);T.x=P*H,T.y=-N*n+m,T.z=P*Y,d.push(T.x,T.y,T.z),y.set(H,b,Y).normalize(),f.push(y.x,y.y,y.z),p.push(B,1-N),O.push(g++)}_.push(O)}for(let A=0;A<s;A++)for(let O=0;O<r;O++){let N=_[O][A],P=_[O+1][A],k=_[O+1][A+1],B=_[O][A+1];(e>0||O!==0)&&(u.push(N,P,B),M+=3),(t>0||O!==r-1)&&(u.push(P,k,B),M+=3)}c.addGroup(v,M,0),v+=M}function S(y){let T=g,M=new Ge,b=new G,A=0,O=y===!0?e:t,N=y===!0?1:-1;for(let k=1;k<=s;k++)d.push(0,m*N,0),f.push(0,N,0),p.push(.5,.5),g++;let P=g;for(let k=0;k<=s;k++){let L=k/s*l+o,H=Math.cos(L),Y=Math.sin(L);b.x=O*Y,b.y=m*N,b.z=O*H,d.push(b.x,b.y,b.z),f.push(0,N,0),M.x=H*.5+.5,M.y=Y*.5*N+.5,p.push(M.x,M.y),g++}for(let k=0;k<s;k++){let B=T+k,L=P+k;y===!0?u.push(L,L+1,B):u.push(L+1,L,B),A+=3}c.addGroup(v,A,y===!0?1:2),v+=A}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Ni=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Je("Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let a=1;a<=e;a++)n=this.getPoint(a/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,a;t?a=t:a=e*n[r-1];let o=0,l=r-1,c;for(;o<=l;)if(s=Math.floor(o+(l-o)/2),c=n[s]-a,c<0)o=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===a)return s/(r-1);let u=n[s],f=n[s+1]-u,p=(a-u)/f;return(s+p)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let a=this.getPoint(s),o=this.getPoint(r),l=t||(a.isVector2?new Ge:new G);return l.copy(o).sub(a).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new G,s=[],r=[],a=[],o=new G,l=new $t;for(let p=0;p<=e;p++){let g=p/e;s[p]=this.getTangentAt(g,new G)}r[0]=new G,a[0]=new G;let c=Number.MAX_VALUE,u=Math.abs(s[0].x),d=Math.abs(s[0].y),f=Math.abs(s[0].z);u<=c&&(c=u,n.set(1,0,0)),d<=c&&(c=d,n.set(0,1,0)),f<=c&&n.set(0,0,1),o.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],o),a[0].crossVectors(s[0],r[0]);for(let p=1;p<=e;p++){if(r[p]=r[p-1].clone(),a[p]=a[p-1].clone(),o.crossVectors(s[p-1],s[p]),o.length()>Number.EPSILON){o.normalize();let g=Math.acos(mt(s[p-1].dot(s[p]),-1,1));r[p].applyMatrix4(l.makeRotationAxis(o,g))}a[p].crossVectors(s[p],r[p])}if(t===!0){let p=Math.acos(mt(r[0].dot(r[e]),-1,1));p/=e,s[0].dot(o.crossVectors(r[0],r[e]))>0&&(p=-p);for(let g=1;g<=e;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],p*g)),a[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:a}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},Wo=class extends Ni{constructor(e=0,t=0,n=1,s=1,r=0,a=Math.PI*2,o=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=a,this.aClockwise=o,this.aRotation=l}getPoint(e,t=new Ge){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,a=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(a?r=0:r=s),this.aClockwise===!0&&!a&&(r===s?r=-s:r=r-s);let o=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(o),c=this.aY+this.yRadius*Math.sin(o);if(this.aRotation!==0){let u=Math.cos(this.aRotation),d=Math.sin(this.aRotation),f=l-this.aX,p=c-this.aY;l=f*u-p*d+this.aX,c=f*d+p*u+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},wc=class extends Wo{constructor(e,t,n,s,r,a){super(e,t,n,n,s,r,a),this.isArcCurve=!0,this.type="ArcCurve"}};function Vd(){let i=0,e=0,t=0,n=0;function s(r,a,o,l){i=r,e=o,t=-3*r+3*a-2*o-l,n=2*r-2*a+o+l}return{initCatmullRom:function(r,a,o,l,c){s(a,o,c*(o-r),c*(l-a))},initNonuniformCatmullRom:function(r,a,o,l,c,u,d){let f=(a-r)/c-(o-r)/(c+u)+(o-a)/u,p=(o-a)/u-(l-a)/(u+d)+(l-o)/d;f*=u,p*=u,s(a,o,f,p)},calc:function(r){let a=r*r,o=a*r;return i+e*r+t*a+n*o}}}var Wp=new G,$p=new G,ed=new Vd,td=new Vd,nd=new Vd,Na=class extends Ni{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new G){let n=t,s=this.points,r=s.length,a=(r-(this.closed?0:1))*e,o=Math.floor(a),l=a-o;this.closed?o+=o>0?0:(Math.floor(Math.abs(o)/r)+1)*r:l===0&&o===r-1&&(o=r-2,l=1);let c,u;this.closed||o>0?c=s[(o-1)%r]:($p.subVectors(s[0],s[1]).add(s[0]),c=$p);let d=s[o%r],f=s[(o+1)%r];if(this.closed||o+2<r?u=s[(o+2)%r]:(Wp.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=Wp),this.curveType==="centripetal"||this.curveType==="chordal"){let p=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(d),p),_=Math.pow(d.distanceToSquared(f),p),m=Math.pow(f.distanceToSquared(u),p);_<1e-4&&(_=1),g<1e-4&&(g=_),m<1e-4&&(m=_),ed.initNonuniformCatmullRom(c.x,d.x,f.x,u.x,g,_,m),td.initNonuniformCatmullRom(c.y,d.y,f.y,u.y,g,_,m),nd.initNonuniformCatmullRom(c.z,d.z,f.z,u.z,g,_,m)}else this.curveType==="catmullrom"&&(ed.initCatmullRom(c.x,d.x,f.x,u.x,this.tension),td.initCatmullRom(c.y,d.y,f.y,u.y,this.tension),nd.initCatmullRom(c.z,d.z,f.z,u.z,this.tension));return n.set(ed.calc(l),td.calc(l),nd.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new G().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function Xp(i,e,t,n,s){let r=(n-e)*.5,a=(s-t)*.5,o=i*i,l=i*o;return(2*t-2*n+r+a)*l+(-3*t+3*n-2*r-a)*o+r*i+t}function H_(i,e){let t=1-i;return t*t*e}function W_(i,e){return 2*(1-i)*i*e}function $_(i,e){return i*i*e}function Ro(i,e,t,n){return H_(i,e)+W_(i,t)+$_(i,n)}function X_(i,e){let t=1-i;return t*t*t*e}function q_(i,e){let t=1-i;return 3*t*t*i*e}function Y_(i,e){return 3*(1-i)*i*i*e}function Z_(i,e){return i*i*i*e}function Po(i,e,t,n,s){return X_(i,e)+q_(i,t)+Y_(i,n)+Z_(i,s)}var Sc=class extends Ni{constructor(e=new Ge,t=new Ge,n=new Ge,s=new Ge){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new Ge){let n=t,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return n.set(Po(e,s.x,r.x,a.x,o.x),Po(e,s.y,r.y,a.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Mc=class extends Ni{constructor(e=new G,t=new G,n=new G,s=new G){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new G){let n=t,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return n.set(Po(e,s.x,r.x,a.x,o.x),Po(e,s.y,r.y,a.y,o.y),Po(e,s.z,r.z,a.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Ec=class extends Ni{constructor(e=new Ge,t=new Ge){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Ge){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Ge){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Tc=class extends Ni{constructor(e=new G,t=new G){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new G){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new G){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Ac=class extends Ni{constructor(e=new Ge,t=new Ge,n=new Ge){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new Ge){let n=t,s=this.v0,r=this.v1,a=this.v2;return n.set(Ro(e,s.x,r.x,a.x),Ro(e,s.y,r.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},$o=class extends Ni{constructor(e=new G,t=new G,n=new G){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new G){let n=t,s=this.v0,r=this.v1,a=this.v2;return n.set(Ro(e,s.x,r.x,a.x),Ro(e,s.y,r.y,a.y),Ro(e,s.z,r.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Cc=class extends Ni{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Ge){let n=t,s=this.points,r=(s.length-1)*e,a=Math.floor(r),o=r-a,l=s[a===0?a:a-1],c=s[a],u=s[a>s.length-2?s.length-1:a+1],d=s[a>s.length-3?s.length-1:a+2];return n.set(Xp(o,l.x,c.x,u.x,d.x),Xp(o,l.y,c.y,u.y,d.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new Ge().fromArray(s))}return this}},K_=Object.freeze({__proto__:null,ArcCurve:wc,CatmullRomCurve3:Na,CubicBezierCurve:Sc,CubicBezierCurve3:Mc,EllipseCurve:Wo,LineCurve:Ec,LineCurve3:Tc,QuadraticBezierCurve:Ac,QuadraticBezierCurve3:$o,SplineCurve:Cc});var Xo=class i extends fn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,a=t/2,o=Math.floor(n),l=Math.floor(s),c=o+1,u=l+1,d=e/o,f=t/l,p=[],g=[],_=[],m=[];for(let v=0;v<u;v++){let x=v*f-a;for(let S=0;S<c;S++){let y=S*d-r;g.push(y,-x,0),_.push(0,0,1),m.push(S/o),m.push(1-v/l)}}for(let v=0;v<l;v++)for(let x=0;x<o;x++){let S=x+c*v,y=x+c*(v+1),T=x+1+c*(v+1),M=x+1+c*v;p.push(S,y,M),p.push(y,T,M)}this.setIndex(p),this.setAttribute("position",new Xt(g,3)),this.setAttribute("normal",new Xt(_,3)),this.setAttribute("uv",new Xt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Dr=class i extends fn{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,a=0,o=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:a,thetaLength:o},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(a+o,Math.PI),c=0,u=[],d=new G,f=new G,p=[],g=[],_=[],m=[];for(let v=0;v<=n;v++){let x=[],S=v/n,y=a+S*o,T=e*Math.cos(y),M=Math.sqrt(e*e-T*T),b=0;v===0&&a===0?b=.5/t:v===n&&l===Math.PI&&(b=-.5/t);for(let A=0;A<=t;A++){let O=A/t,N=s+O*r;d.x=-M*Math.cos(N),d.y=T,d.z=M*Math.sin(N),g.push(d.x,d.y,d.z),f.copy(d).normalize(),_.push(f.x,f.y,f.z),m.push(O+b,1-S),x.push(c++)}u.push(x)}for(let v=0;v<n;v++)for(let x=0;x<t;x++){let S=u[v][x+1],y=u[v][x],T=u[v+1][x],M=u[v+1][x+1];(v!==0||a>0)&&p.push(S,y,M),(v!==n-1||l<Math.PI)&&p.push(y,T,M)}this.setIndex(p),this.setAttribute("position",new Xt(g,3)),this.setAttribute("normal",new Xt(_,3)),this.setAttribute("uv",new Xt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var qo=class i extends fn{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],u=[],d=[],f=new G,p=new G,g=new G;for(let _=0;_<=n;_++){let m=a+_/n*o;for(let v=0;v<=s;v++){let x=v/s*r;p.x=(e+t*Math.cos(m))*Math.cos(x),p.y=(e+t*Math.cos(m))*Math.sin(x),p.z=t*Math.sin(m),c.push(p.x,p.y,p.z),f.x=e*Math.cos(x),f.y=e*Math.sin(x),g.subVectors(p,f).normalize(),u.push(g.x,g.y,g.z),d.push(v/s),d.push(_/n)}}for(let _=1;_<=n;_++)for(let m=1;m<=s;m++){let v=(s+1)*_+m-1,x=(s+1)*(_-1)+m-1,S=(s+1)*(_-1)+m,y=(s+1)*_+m;l.push(v,x,y),l.push(x,S,y)}this.setIndex(l),this.setAttribute("position",new Xt(c,3)),this.setAttribute("normal",new Xt(u,3)),this.setAttribute("uv",new Xt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var Yo=class i extends fn{constructor(e=new $o(new G(-1,-1,0),new G(-1,1,0),new G(1,1,0)),t=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:e,tubularSegments:t,radius:n,radialSegments:s,closed:r};let a=e.computeFrenetFrames(t,r);this.tangents=a.tangents,this.normals=a.normals,this.binormals=a.binormals;let o=new G,l=new G,c=new Ge,u=new G,d=[],f=[],p=[],g=[];_(),this.setIndex(g),this.setAttribute("position",new Xt(d,3)),this.setAttribute("normal",new Xt(f,3)),this.setAttribute("uv",new Xt(p,2));function _(){for(let S=0;S<t;S++)m(S);m(r===!1?t:0),x(),v()}function m(S){u=e.getPointAt(S/t,u);let y=a.normals[S],T=a.binormals[S];for(let M=0;M<=s;M++){let b=M/s*Math.PI*2,A=Math.sin(b),O=-Math.cos(b);l.x=O*y.x+A*T.x,l.y=O*y.y+A*T.y,l.z=O*y.z+A*T.z,l.normalize(),f.push(l.x,l.y,l.z),o.x=u.x+n*l.x,o.y=u.y+n*l.y,o.z=u.z+n*l.z,d.push(o.x,o.y,o.z)}}function v(){for(let S=1;S<=t;S++)for(let y=1;y<=s;y++){let T=(s+1)*(S-1)+(y-1),M=(s+1)*S+(y-1),b=(s+1)*S+y,A=(s+1)*(S-1)+y;g.push(T,M,A),g.push(M,b,A)}}function x(){for(let S=0;S<=t;S++)for(let y=0;y<=s;y++)c.x=S/t,c.y=y/s,p.push(c.x,c.y)}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON();return e.path=this.parameters.path.toJSON(),e}static fromJSON(e){return new i(new K_[e.path.type]().fromJSON(e.path),e.tubularSegments,e.radius,e.radialSegments,e.closed)}};function Br(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(qp(s))s.isRenderTargetTexture?(Je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(qp(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Wn(i){let e={};for(let t=0;t<i.length;t++){let n=Br(i[t]);for(let s in n)e[s]=n[s]}return e}function qp(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function j_(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Gd(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Mt.workingColorSpace}var zm={clone:Br,merge:Wn},J_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Q_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ds=class extends Is{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=J_,this.fragmentShader=Q_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Br(e.uniforms),this.uniformsGroups=j_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Qe().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ge().fromArray(s.value);break;case"v3":this.uniforms[n].value=new G().fromArray(s.value);break;case"v4":this.uniforms[n].value=new tn().fromArray(s.value);break;case"m3":this.uniforms[n].value=new lt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new $t().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Rc=class extends ds{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ei=class extends Is{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Qe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ph,this.normalScale=new Ge(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ls,this.combine=Wc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Pc=class extends Is{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Mm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Lc=class extends Is{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var Zo=class extends Ds{constructor(e){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(e)}copy(e){return super.copy(e),this.scale=e.scale,this.dashSize=e.dashSize,this.gapSize=e.gapSize,this}};function Sa(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Ql(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var rr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let a;t:{i:if(!(e<s)){for(let o=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=t[++n],e<s)break e}a=t.length;break t}if(!(e>=r)){let o=t[1];e<o&&(n=2,r=o);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}a=n,n=0;break t}break n}for(;n<a;){let o=n+a>>>1;e<t[o]?a=o:n=o+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let a=0;a!==s;++a)t[a]=n[r+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ic=class extends rr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:rd,endingEnd:rd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,a=e+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case ad:r=e,o=2*t-n;break;case od:r=s.length-2,o=t+s[r]-s[r+1];break;default:r=e,o=n}if(l===void 0)switch(this.getSettings_().endingEnd){case ad:a=e,l=2*n-t;break;case od:a=1,l=n+s[1]-s[0];break;default:a=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=a*u}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,u=this._offsetPrev,d=this._offsetNext,f=this._weightPrev,p=this._weightNext,g=(n-t)/(s-t),_=g*g,m=_*g,v=-f*m+2*f*_-f*g,x=(1+f)*m+(-1.5-2*f)*_+(-.5+f)*g+1,S=(-1-p)*m+(1.5+p)*_+.5*g,y=p*m-p*_;for(let T=0;T!==o;++T)r[T]=v*a[u+T]+x*a[c+T]+S*a[l+T]+y*a[d+T];return r}},Dc=class extends rr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,u=(n-t)/(s-t),d=1-u;for(let f=0;f!==o;++f)r[f]=a[c+f]*d+a[l+f]*u;return r}},Nc=class extends rr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},kc=class extends rr{interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,u=this.inTangents,d=this.outTangents;if(!u||!d){let g=(n-t)/(s-t),_=1-g;for(let m=0;m!==o;++m)r[m]=a[c+m]*_+a[l+m]*g;return r}let f=o*2,p=e-1;for(let g=0;g!==o;++g){let _=a[c+g],m=a[l+g],v=p*f+g*2,x=d[v],S=d[v+1],y=e*f+g*2,T=u[y],M=u[y+1],b=ty(n,t,x,T,s);r[g]=Vm(b,_,S,M,m)}return r}};function Vm(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function ey(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function ty(i,e,t,n,s){let r=(i-e)/(s-e);for(let a=0;a<8;a++){let o=Vm(r,e,t,n,s)-i;if(Math.abs(o)<1e-10)break;let l=ey(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var wi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Sa(t,this.TimeBufferType),this.values=Sa(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Sa(e.times,Array),values:Sa(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Ql(e.settings)&&(n.settings={inTangents:Sa(e.settings.inTangents,Array),outTangents:Sa(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Nc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Dc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Ic(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new kc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Lo:t=this.InterpolantFactoryMethodDiscrete;break;case fc:t=this.InterpolantFactoryMethodLinear;break;case nc:t=this.InterpolantFactoryMethodSmooth;break;case sd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Je("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Lo;case this.InterpolantFactoryMethodLinear:return fc;case this.InterpolantFactoryMethodSmooth:return nc;case this.InterpolantFactoryMethodBezier:return sd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Ql(this.settings)&&(Yp(this.settings.inTangents,e),Yp(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Ql(this.settings)&&(Zp(this.settings.inTangents,e),Zp(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<e;)++r;for(;a!==-1&&n[a]>t;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(ot("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ot("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==r;o++){let l=n[o];if(typeof l=="number"&&isNaN(l)){ot("KeyframeTrack: Time is not a valid number.",this,o,l),e=!1;break}if(a!==null&&a>l){ot("KeyframeTrack: Out of order keys.",this,o,l,a),e=!1;break}a=l}if(s!==void 0&&c_(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){ot("KeyframeTrack: Value is not a valid number.",this,o,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===nc,r=e.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=e[o],u=e[o+1];if(c!==u&&(o!==1||c!==e[0]))if(s)l=!0;else{let d=o*n,f=d-n,p=d+n;for(let g=0;g!==n;++g){let _=t[d+g];if(_!==t[f+g]||_!==t[p+g]){l=!0;break}}}if(l){if(o!==a){e[a]=e[o];let d=o*n,f=a*n;for(let p=0;p!==n;++p)t[f+p]=t[d+p]}++a}}if(r>0){e[a]=e[r];for(let o=r*n,l=a*n,c=0;c!==n;++c)t[l+c]=t[o+c];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Ql(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Yp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Zp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}wi.prototype.ValueTypeName="";wi.prototype.TimeBufferType=Float32Array;wi.prototype.ValueBufferType=Float32Array;wi.prototype.DefaultInterpolation=fc;var ar=class extends wi{constructor(e,t,n){super(e,t,n)}};ar.prototype.ValueTypeName="bool";ar.prototype.ValueBufferType=Array;ar.prototype.DefaultInterpolation=Lo;ar.prototype.InterpolantFactoryMethodLinear=void 0;ar.prototype.InterpolantFactoryMethodSmooth=void 0;var Fc=class extends wi{constructor(e,t,n,s){super(e,t,n,s)}};Fc.prototype.ValueTypeName="color";var Uc=class extends wi{constructor(e,t,n,s){super(e,t,n,s)}};Uc.prototype.ValueTypeName="number";var Oc=class extends rr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(n-t)/(s-t),c=e*o;for(let u=c+o;c!==u;c+=4)Qn.slerpFlat(r,0,a,c-o,a,c,l);return r}},Ko=class extends wi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Oc(this.times,this.values,this.getValueSize(),e)}};Ko.prototype.ValueTypeName="quaternion";Ko.prototype.InterpolantFactoryMethodSmooth=void 0;var or=class extends wi{constructor(e,t,n){super(e,t,n)}};or.prototype.ValueTypeName="string";or.prototype.ValueBufferType=Array;or.prototype.DefaultInterpolation=Lo;or.prototype.InterpolantFactoryMethodLinear=void 0;or.prototype.InterpolantFactoryMethodSmooth=void 0;var Bc=class extends wi{constructor(e,t,n,s){super(e,t,n,s)}};Bc.prototype.ValueTypeName="vector";var zc=class{constructor(e,t,n){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){o++,r===!1&&s.onStart!==void 0&&s.onStart(u,a,o),r=!0},this.itemEnd=function(u){a++,s.onProgress!==void 0&&s.onProgress(u,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,f=c.length;d<f;d+=2){let p=c[d],g=c[d+1];if(p.global&&(p.lastIndex=0),p.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Gm=new zc,Vc=class{constructor(e){this.manager=e!==void 0?e:Gm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Vc.DEFAULT_MATERIAL_NAME="__DEFAULT";var jo=class extends Hn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Qe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var id=new $t,Kp=new G,jp=new G,Gc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ge(512,512),this.mapType=oi,this.map=null,this.mapPass=null,this.matrix=new $t,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new sr,this._frameExtents=new Ge(1,1),this._viewportCount=1,this._viewports=[new tn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Kp.setFromMatrixPosition(e.matrixWorld),t.position.copy(Kp),jp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(jp),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){id.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(id,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Ca||e.reversedDepth?t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,1,0,0,0,0,1):t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,.5,.5,0,0,0,1),t.multiply(id)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},ec=new G,tc=new Qn,cs=new G,Jo=class extends Hn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new $t,this.projectionMatrix=new $t,this.projectionMatrixInverse=new $t,this.coordinateSystem=Di,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ec,tc,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ec,tc,cs.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(ec,tc,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ec,tc,cs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},tr=new G,Jp=new Ge,Qp=new Ge,xi=class extends Jo{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Pa*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ao*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Pa*2*Math.atan(Math.tan(Ao*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){tr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(tr.x,tr.y).multiplyScalar(-e/tr.z),tr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(tr.x,tr.y).multiplyScalar(-e/tr.z)}getViewSize(e,t){return this.getViewBounds(e,Jp,Qp),t.subVectors(Qp,Jp)}setViewOffset(e,t,n,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ao*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}let o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Nr=class extends Jo{constructor(e=-1,t=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,a=n+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=u*this.view.offsetY,l=o-u*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},ld=class extends Gc{constructor(){super(new Nr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Qo=class extends jo{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Hn.DEFAULT_UP),this.updateMatrix(),this.target=new Hn,this.shadow=new ld}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},el=class extends jo{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var Ma=-90,Ea=1,ka=class extends Hn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new xi(Ma,Ea,e,t);s.layers=this.layers,this.add(s);let r=new xi(Ma,Ea,e,t);r.layers=this.layers,this.add(r);let a=new xi(Ma,Ea,e,t);a.layers=this.layers,this.add(a);let o=new xi(Ma,Ea,e,t);o.layers=this.layers,this.add(o);let l=new xi(Ma,Ea,e,t);l.layers=this.layers,this.add(l);let c=new xi(Ma,Ea,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,a,o,l]=t;for(let c of t)this.remove(c);if(e===Di)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ca)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,u]=this.children,d=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let _=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=_,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,f,p),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Hc=class extends xi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Hd="\\[\\]\\.:\\/",ny=new RegExp("["+Hd+"]","g"),Wd="[^"+Hd+"]",iy="[^"+Hd.replace("\\.","")+"]",sy=/((?:WC+[\/:])*)/.source.replace("WC",Wd),ry=/(WCOD+)?/.source.replace("WCOD",iy),ay=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Wd),oy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Wd),ly=new RegExp("^"+sy+ry+ay+oy+"$"),cy=["material","materials","bones","map"],cd=class{constructor(e,t,n){let s=n||jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},jt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(ny,"")}static parseTrackName(e){let t=ly.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);cy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===t||o.uuid===t)return o;let l=n(o.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Je("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){ot("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){ot("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){ot("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){ot("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){ot("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let a=e[s];if(a===void 0){let c=t.nodeName;ot("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};jt.Composite=cd;jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};jt.prototype.GetterByBindingType=[jt.prototype._getValue_direct,jt.prototype._getValue_array,jt.prototype._getValue_arrayElement,jt.prototype._getValue_toArray];jt.prototype.SetterByBindingTypeAndVersioning=[[jt.prototype._setValue_direct,jt.prototype._setValue_direct_setNeedsUpdate,jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_array,jt.prototype._setValue_array_setNeedsUpdate,jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_arrayElement,jt.prototype._setValue_arrayElement_setNeedsUpdate,jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_fromArray,jt.prototype._setValue_fromArray_setNeedsUpdate,jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var $T=new Float32Array(1);var Fa=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=mt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(mt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var hd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var tl=class extends Xi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function $d(i,e,t,n){let s=hy(n);switch(t){case Rd:return i*e;case Ld:return i*e/s.components*s.byteLength;case jc:return i*e/s.components*s.byteLength;case ur:return i*e*2/s.components*s.byteLength;case Jc:return i*e*2/s.components*s.byteLength;case Pd:return i*e*3/s.components*s.byteLength;case Ki:return i*e*4/s.components*s.byteLength;case Qc:return i*e*4/s.components*s.byteLength;case sl:case rl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case al:case ol:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case th:case ih:return Math.max(i,16)*Math.max(e,8)/4;case eh:case nh:return Math.max(i,8)*Math.max(e,8)/2;case sh:case rh:case oh:case lh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ah:case ll:case ch:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case hh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case uh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case dh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case fh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ph:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case mh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case gh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case vh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case _h:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case yh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case xh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case bh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case wh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Sh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Mh:case Eh:case Th:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Ah:case Ch:return Math.ceil(i/4)*Math.ceil(e/4)*8;case cl:case Rh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function hy(i){switch(i){case oi:case Ed:return{byteLength:1,components:1};case za:case Td:case Zi:return{byteLength:2,components:1};case Zc:case Kc:return{byteLength:2,components:4};case qi:case Yc:case Yi:return{byteLength:4,components:1};case Ad:case Cd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function hg(){let i=null,e=!1,t=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function dy(i){let e=new WeakMap;function t(o,l){let c=o.array,u=o.usage,d=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),o.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:d}}function n(o,l,c){let u=l.array,d=l.updateRanges;if(i.bindBuffer(c,o),d.length===0)i.bufferSubData(c,0,u);else{d.sort((p,g)=>p.start-g.start);let f=0;for(let p=1;p<d.length;p++){let g=d[f],_=d[p];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++f,d[f]=_)}d.length=f+1;for(let p=0,g=d.length;p<g;p++){let _=d[p];i.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=e.get(o);l&&(i.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let u=e.get(o);(!u||u.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var fy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,py=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,my=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,gy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,vy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,_y=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,yy=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,xy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,by=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,wy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Sy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,My=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Ey=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Ty=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Ay=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Cy=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Ry=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Py=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ly=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Iy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Dy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Ny=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,ky=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Fy=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Uy=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Oy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,By=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,zy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Vy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Gy="gl_FragColor = linearToOutputTexel( gl_FragColor );",Hy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Wy=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,$y=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Xy=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,qy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Yy=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Zy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ky=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,jy=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Jy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Qy=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,ex=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,tx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,nx=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ix=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,sx=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,rx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ax=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,ox=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,lx=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,cx=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,hx=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,ux=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,dx=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,fx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,px=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,mx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,gx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,_x=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,yx=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,xx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,bx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,wx=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Sx=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Mx=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Ex=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Tx=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Ax=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Cx=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Rx=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Px=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Lx=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Ix=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Dx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Nx=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,kx=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Fx=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Ux=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Ox=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Bx=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,zx=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Vx=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Gx=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Hx=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Wx=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,$x=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Xx=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,qx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Yx=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Zx=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Kx=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,jx=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Jx=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Qx=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,eb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,tb=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,nb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ib=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,sb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,rb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,ab=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,ob=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,lb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,cb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,hb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,ub=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,db=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,fb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,pb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,mb=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_b=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,yb=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,xb=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,bb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,wb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Sb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Mb=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Eb=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Tb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Ab=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Cb=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Rb=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Pb=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Lb=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ib=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Db=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Nb=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,kb=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Fb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Ub=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ob=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Bb=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,zb=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Vb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Gb=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Hb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Wb=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,$b=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,gt={alphahash_fragment:fy,alphahash_pars_fragment:py,alphamap_fragment:my,alphamap_pars_fragment:gy,alphatest_fragment:vy,alphatest_pars_fragment:_y,aomap_fragment:yy,aomap_pars_fragment:xy,batching_pars_vertex:by,batching_vertex:wy,begin_vertex:Sy,beginnormal_vertex:My,bsdfs:Ey,iridescence_fragment:Ty,bumpmap_pars_fragment:Ay,clipping_planes_fragment:Cy,clipping_planes_pars_fragment:Ry,clipping_planes_pars_vertex:Py,clipping_planes_vertex:Ly,color_fragment:Iy,color_pars_fragment:Dy,color_pars_vertex:Ny,color_vertex:ky,common:Fy,defaultnormal_vertex:Uy,displacementmap_pars_vertex:Oy,displacementmap_vertex:By,emissivemap_fragment:zy,emissivemap_pars_fragment:Vy,colorspace_fragment:Gy,colorspace_pars_fragment:Hy,envmap_fragment:Wy,envmap_common_pars_fragment:$y,envmap_pars_fragment:Xy,envmap_pars_vertex:qy,envmap_physical_pars_fragment:sx,envmap_vertex:Yy,fog_vertex:Zy,fog_pars_vertex:Ky,fog_fragment:jy,fog_pars_fragment:Jy,gradientmap_pars_fragment:Qy,lightmap_pars_fragment:ex,lights_lambert_fragment:tx,lights_lambert_pars_fragment:nx,lights_pars_begin:ix,lights_toon_fragment:rx,lights_toon_pars_fragment:ax,lights_phong_fragment:ox,lights_phong_pars_fragment:lx,lights_physical_fragment:cx,lights_physical_pars_fragment:hx,lights_fragment_begin:ux,lights_fragment_maps:dx,lights_fragment_end:fx,lightprobes_pars_fragment:px,logdepthbuf_fragment:mx,logdepthbuf_pars_fragment:gx,logdepthbuf_pars_vertex:vx,logdepthbuf_vertex:_x,map_fragment:yx,map_pars_fragment:xx,map_particle_fragment:bx,map_particle_pars_fragment:wx,metalnessmap_fragment:Sx,metalnessmap_pars_fragment:Mx,morphinstance_vertex:Ex,morphcolor_vertex:Tx,morphnormal_vertex:Ax,morphtarget_pars_vertex:Cx,morphtarget_vertex:Rx,normal_fragment_begin:Px,normal_fragment_maps:Lx,normal_pars_fragment:Ix,normal_pars_vertex:Dx,normal_vertex:Nx,normalmap_pars_fragment:kx,clearcoat_normal_fragment_begin:Fx,clearcoat_normal_fragment_maps:Ux,clearcoat_pars_fragment:Ox,iridescence_pars_fragment:Bx,opaque_fragment:zx,packing:Vx,premultiplied_alpha_fragment:Gx,project_vertex:Hx,dithering_fragment:Wx,dithering_pars_fragment:$x,roughnessmap_fragment:Xx,roughnessmap_pars_fragment:qx,shadowmap_pars_fragment:Yx,shadowmap_pars_vertex:Zx,shadowmap_vertex:Kx,shadowmask_pars_fragment:jx,skinbase_vertex:Jx,skinning_pars_vertex:Qx,skinning_vertex:eb,skinnormal_vertex:tb,specularmap_fragment:nb,specularmap_pars_fragment:ib,tonemapping_fragment:sb,tonemapping_pars_fragment:rb,transmission_fragment:ab,transmission_pars_fragment:ob,uv_pars_fragment:lb,uv_pars_vertex:cb,uv_vertex:hb,worldpos_vertex:ub,background_vert:db,background_frag:fb,backgroundCube_vert:pb,backgroundCube_frag:mb,cube_vert:gb,cube_frag:vb,depth_vert:_b,depth_frag:yb,distance_vert:xb,distance_frag:bb,equirect_vert:wb,equirect_frag:Sb,linedashed_vert:Mb,linedashed_frag:Eb,meshbasic_vert:Tb,meshbasic_frag:Ab,meshlambert_vert:Cb,meshlambert_frag:Rb,meshmatcap_vert:Pb,meshmatcap_frag:Lb,meshnormal_vert:Ib,meshnormal_frag:Db,meshphong_vert:Nb,meshphong_frag:kb,meshphysical_vert:Fb,meshphysical_frag:Ub,meshtoon_vert:Ob,meshtoon_frag:Bb,points_vert:zb,points_frag:Vb,shadow_vert:Gb,shadow_frag:Hb,sprite_vert:Wb,sprite_frag:$b},Ue={common:{diffuse:{value:new Qe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new lt},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new lt}},envmap:{envMap:{value:null},envMapRotation:{value:new lt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new lt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new lt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new lt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new lt},normalScale:{value:new Ge(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new lt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new lt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new lt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new lt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Qe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Qe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0},uvTransform:{value:new lt}},sprite:{diffuse:{value:new Qe(16777215)},opacity:{value:1},center:{value:new Ge(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new lt},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0}}},ms={basic:{uniforms:Wn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.fog]),vertexShader:gt.meshbasic_vert,fragmentShader:gt.meshbasic_frag},lambert:{uniforms:Wn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new Qe(0)},envMapIntensity:{value:1}}]),vertexShader:gt.meshlambert_vert,fragmentShader:gt.meshlambert_frag},phong:{uniforms:Wn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new Qe(0)},specular:{value:new Qe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:gt.meshphong_vert,fragmentShader:gt.meshphong_frag},standard:{uniforms:Wn([Ue.common,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.roughnessmap,Ue.metalnessmap,Ue.fog,Ue.lights,{emissive:{value:new Qe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag},toon:{uniforms:Wn([Ue.common,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.gradientmap,Ue.fog,Ue.lights,{emissive:{value:new Qe(0)}}]),vertexShader:gt.meshtoon_vert,fragmentShader:gt.meshtoon_frag},matcap:{uniforms:Wn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,{matcap:{value:null}}]),vertexShader:gt.meshmatcap_vert,fragmentShader:gt.meshmatcap_frag},points:{uniforms:Wn([Ue.points,Ue.fog]),vertexShader:gt.points_vert,fragmentShader:gt.points_frag},dashed:{uniforms:Wn([Ue.common,Ue.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:gt.linedashed_vert,fragmentShader:gt.linedashed_frag},depth:{uniforms:Wn([Ue.common,Ue.displacementmap]),vertexShader:gt.depth_vert,fragmentShader:gt.depth_frag},normal:{uniforms:Wn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,{opacity:{value:1}}]),vertexShader:gt.meshnormal_vert,fragmentShader:gt.meshnormal_frag},sprite:{uniforms:Wn([Ue.sprite,Ue.fog]),vertexShader:gt.sprite_vert,fragmentShader:gt.sprite_frag},background:{uniforms:{uvTransform:{value:new lt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:gt.background_vert,fragmentShader:gt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new lt}},vertexShader:gt.backgroundCube_vert,fragmentShader:gt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:gt.cube_vert,fragmentShader:gt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:gt.equirect_vert,fragmentShader:gt.equirect_frag},distance:{uniforms:Wn([Ue.common,Ue.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:gt.distance_vert,fragmentShader:gt.distance_frag},shadow:{uniforms:Wn([Ue.lights,Ue.fog,{color:{value:new Qe(0)},opacity:{value:1}}]),vertexShader:gt.shadow_vert,fragmentShader:gt.shadow_frag}};ms.physical={uniforms:Wn([ms.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new lt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new lt},clearcoatNormalScale:{value:new Ge(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new lt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new lt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new lt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new lt},sheen:{value:0},sheenColor:{value:new Qe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new lt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new lt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new lt},transmissionSamplerSize:{value:new Ge},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new lt},attenuationDistance:{value:0},attenuationColor:{value:new Qe(0)},specularColor:{value:new Qe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new lt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new lt},anisotropyVector:{value:new Ge},anisotropyMap:{value:null},anisotropyMapTransform:{value:new lt}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag};var Lh={r:0,b:0,g:0},Xb=new $t,ug=new lt;ug.set(-1,0,0,0,1,0,0,0,1);function qb(i,e,t,n,s,r){let a=new Qe(0),o=s===!0?0:1,l,c,u=null,d=0,f=null;function p(x){let S=x.isScene===!0?x.background:null;if(S&&S.isTexture){let y=x.backgroundBlurriness>0;S=e.get(S,y)}return S}function g(x){let S=!1,y=p(x);y===null?m(a,o):y&&y.isColor&&(m(y,1),S=!0);let T=i.xr.getEnvironmentBlendMode();T==="additive"?t.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||S)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function _(x,S){let y=p(S);y&&y.isCubeTexture?(c===void 0&&(c=new hn(new ks(1,1,1),new ds({name:"BackgroundCubeMaterial",uniforms:Br(ms.backgroundCube.uniforms),vertexShader:ms.backgroundCube.vertexShader,fragmentShader:ms.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,M,b){this.matrixWorld.copyPosition(b.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=y,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Xb.makeRotationFromEuler(S.backgroundRotation)).transpose(),y.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(ug),c.material.toneMapped=Mt.getTransfer(y.colorSpace)!==Nt,(u!==y||d!==y.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,u=y,d=y.version,f=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):y&&y.isTexture&&(l===void 0&&(l=new hn(new Xo(2,2),new ds({name:"BackgroundMaterial",uniforms:Br(ms.background.uniforms),vertexShader:ms.background.vertexShader,fragmentShader:ms.background.fragmentShader,side:hr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=y,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=Mt.getTransfer(y.colorSpace)!==Nt,y.matrixAutoUpdate===!0&&y.updateMatrix(),l.material.uniforms.uvTransform.value.copy(y.matrix),(u!==y||d!==y.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,u=y,d=y.version,f=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,S){x.getRGB(Lh,Gd(i)),t.buffers.color.setClear(Lh.r,Lh.g,Lh.b,S,r)}function v(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(x,S=1){a.set(x),o=S,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(x){o=x,m(a,o)},render:g,addToRenderList:_,dispose:v}}function Yb(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,a=!1;function o(P,k,B,L,H){let Y=!1,$=d(P,L,B,k);r!==$&&(r=$,c(r.object)),Y=p(P,L,B,H),Y&&g(P,L,B,H),H!==null&&e.update(H,i.ELEMENT_ARRAY_BUFFER),(Y||a)&&(a=!1,y(P,k,B,L),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return i.createVertexArray()}function c(P){return i.bindVertexArray(P)}function u(P){return i.deleteVertexArray(P)}function d(P,k,B,L){let H=L.wireframe===!0,Y=n[k.id];Y===void 0&&(Y={},n[k.id]=Y);let $=P.isInstancedMesh===!0?P.id:0,ce=Y[$];ce===void 0&&(ce={},Y[$]=ce);let K=ce[B.id];K===void 0&&(K={},ce[B.id]=K);let ee=K[H];return ee===void 0&&(ee=f(l()),K[H]=ee),ee}function f(P){let k=[],B=[],L=[];for(let H=0;H<t;H++)k[H]=0,B[H]=0,L[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:B,attributeDivisors:L,object:P,attributes:{},index:null}}function p(P,k,B,L){let H=r.attributes,Y=k.attributes,$=0,ce=B.getAttributes();for(let K in ce)if(ce[K].location>=0){let ne=H[K],ue=Y[K];if(ue===void 0&&(K==="instanceMatrix"&&P.instanceMatrix&&(ue=P.instanceMatrix),K==="instanceColor"&&P.instanceColor&&(ue=P.instanceColor)),ne===void 0||ne.attribute!==ue||ue&&ne.data!==ue.data)return!0;$++}return r.attributesNum!==$||r.index!==L}function g(P,k,B,L){let H={},Y=k.attributes,$=0,ce=B.getAttributes();for(let K in ce)if(ce[K].location>=0){let ne=Y[K];ne===void 0&&(K==="instanceMatrix"&&P.instanceMatrix&&(ne=P.instanceMatrix),K==="instanceColor"&&P.instanceColor&&(ne=P.instanceColor));let ue={};ue.attribute=ne,ne&&ne.data&&(ue.data=ne.data),H[K]=ue,$++}r.attributes=H,r.attributesNum=$,r.index=L}function _(){let P=r.newAttributes;for(let k=0,B=P.length;k<B;k++)P[k]=0}function m(P){v(P,0)}function v(P,k){let B=r.newAttributes,L=r.enabledAttributes,H=r.attributeDivisors;B[P]=1,L[P]===0&&(i.enableVertexAttribArray(P),L[P]=1),H[P]!==k&&(i.vertexAttribDivisor(P,k),H[P]=k)}function x(){let P=r.newAttributes,k=r.enabledAttributes;for(let B=0,L=k.length;B<L;B++)k[B]!==P[B]&&(i.disableVertexAttribArray(B),k[B]=0)}function S(P,k,B,L,H,Y,$){$===!0?i.vertexAttribIPointer(P,k,B,H,Y):i.vertexAttribPointer(P,k,B,L,H,Y)}function y(P,k,B,L){_();let H=L.attributes,Y=B.getAttributes(),$=k.defaultAttributeValues;for(let ce in Y){let K=Y[ce];if(K.location>=0){let ee=H[ce];if(ee===void 0&&(ce==="instanceMatrix"&&P.instanceMatrix&&(ee=P.instanceMatrix),ce==="instanceColor"&&P.instanceColor&&(ee=P.instanceColor)),ee!==void 0){let ne=ee.normalized,ue=ee.itemSize,de=e.get(ee);if(de===void 0)continue;let Q=de.buffer,ge=de.type,ye=de.bytesPerElement,Te=ge===i.INT||ge===i.UNSIGNED_INT||ee.gpuType===Yc;if(ee.isInterleavedBufferAttribute){let be=ee.data,Ye=be.isInterleavedBuffer===!0?be.stride:be.itemSize,he=ee.offset;if(be.isInstancedInterleavedBuffer||be.isInstancedBufferAttribute){for(let Ie=0;Ie<K.locationSize;Ie++)v(K.location+Ie,be.meshPerAttribute);P.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=be.meshPerAttribute*be.count)}else for(let Ie=0;Ie<K.locationSize;Ie++)m(K.location+Ie);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Ie=0;Ie<K.locationSize;Ie++)S(K.location+Ie,ue/K.locationSize,ge,ne,Ye*ye,(he+ue/K.locationSize*Ie)*ye,Te)}else{if(ee.isInstancedBufferAttribute){for(let be=0;be<K.locationSize;be++)v(K.location+be,ee.meshPerAttribute);P.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let be=0;be<K.locationSize;be++)m(K.location+be);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let be=0;be<K.locationSize;be++)S(K.location+be,ue/K.locationSize,ge,ne,ue*ye,ue/K.locationSize*be*ye,Te)}}else if($!==void 0){let ne=$[ce];if(ne!==void 0)switch(ne.length){case 2:i.vertexAttrib2fv(K.location,ne);break;case 3:i.vertexAttrib3fv(K.location,ne);break;case 4:i.vertexAttrib4fv(K.location,ne);break;default:i.vertexAttrib1fv(K.location,ne)}}}}x()}function T(){O();for(let P in n){let k=n[P];for(let B in k){let L=k[B];for(let H in L){let Y=L[H];for(let $ in Y)u(Y[$].object),delete Y[$];delete L[H]}}delete n[P]}}function M(P){if(n[P.id]===void 0)return;let k=n[P.id];for(let B in k){let L=k[B];for(let H in L){let Y=L[H];for(let $ in Y)u(Y[$].object),delete Y[$];delete L[H]}}delete n[P.id]}function b(P){for(let k in n){let B=n[k];for(let L in B){let H=B[L];if(H[P.id]===void 0)continue;let Y=H[P.id];for(let $ in Y)u(Y[$].object),delete Y[$];delete H[P.id]}}}function A(P){for(let k in n){let B=n[k],L=P.isInstancedMesh===!0?P.id:0,H=B[L];if(H!==void 0){for(let Y in H){let $=H[Y];for(let ce in $)u($[ce].object),delete $[ce];delete H[Y]}delete B[L],Object.keys(B).length===0&&delete n[k]}}}function O(){N(),a=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:O,resetDefaultState:N,dispose:T,releaseStatesOfGeometry:M,releaseStatesOfObject:A,releaseStatesOfProgram:b,initAttributes:_,enableAttribute:m,disableUnusedAttributes:x}}function Zb(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function a(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),t.update(c,n,u))}function o(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let f=0;for(let p=0;p<u;p++)f+=c[p];t.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function Kb(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let b=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(b.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(b){return!(b!==Ki&&n.convert(b)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(b){let A=b===Zi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(b!==oi&&b!==Yi&&!A&&n.convert(b)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(b){if(b==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";b="mediump"}return b==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),v=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),T=i.getParameter(i.MAX_SAMPLES),M=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:m,maxAttributes:v,maxVertexUniforms:x,maxVaryings:S,maxFragmentUniforms:y,maxSamples:T,samples:M}}function jb(i){let e=this,t=null,n=0,s=!1,r=!1,a=new yi,o=new lt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,f){let p=d.length!==0||f||n!==0||s;return s=f,n=d.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,f){t=u(d,f,0)},this.setState=function(d,f,p){let g=d.clippingPlanes,_=d.clipIntersection,m=d.clipShadows,v=i.get(d);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{let x=r?0:n,S=x*4,y=v.clippingState||null;l.value=y,y=u(g,f,S,p);for(let T=0;T!==S;++T)y[T]=t[T];v.clippingState=y,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(d,f,p,g){let _=d!==null?d.length:0,m=null;if(_!==0){if(m=l.value,g!==!0||m===null){let v=p+_*4,x=f.matrixWorldInverse;o.getNormalMatrix(x),(m===null||m.length<v)&&(m=new Float32Array(v));for(let S=0,y=p;S!==_;++S,y+=4)a.copy(d[S]).applyMatrix4(x,o),a.normal.toArray(m,y),m[y+3]=a.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,m}}var dl=class extends bi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Vo(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new ks(5,5,5),r=new ds({name:"CubemapFromEquirect",uniforms:Br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ti,blending:kr});r.uniforms.tEquirect.value=t;let a=new hn(s,r),o=t.minFilter;return t.minFilter===Fs&&(t.minFilter=Jn),new ka(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,n,s);e.setRenderTarget(r)}},Hm=256,Jb=3,Qb=20,dg=256,fg=16,ew=3,tw=new G,nw=new Qe,Dh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ka(1,10,null),this._boxMesh=new hn(new ks(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:a=256,position:o=tw}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,f=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(nw));let m=new ka(n,s,u);return m.position.copy(o),m.update(l,e),l.autoClear=d,l.autoClearColor=f,l.autoClearDepth=p,l.autoClearStencil=g,e.background=_,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Xm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=$m(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Hm,Od(e))}_fromTexture(e,t){e.mapping===Ur||e.mapping===Ba?this._setSize(e.image.length===0?Hm:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Wm(e,!1,!1),n=Math.log2(e)-Jb;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Wm(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ur||e.mapping===Ba?(this._cubemapMaterial===null&&(this._cubemapMaterial=Xm()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=$m()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=iw(),this._integrationMaterial=sw());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/fg);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-ew)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let l=o>0?Math.log2(t)+.5*Math.log2(6/(dg*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=rw());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function Wm(i,e,t){return new dl(i,{minFilter:Fs,generateMipmaps:e,type:Zi,colorSpace:Io,depthBuffer:t})}function fl(i,e,t){return new ds({name:i,uniforms:e,vertexShader:gt.cube_vert,fragmentShader:t,side:ti,blending:kr,depthTest:!1,depthWrite:!1})}function iw(){return fl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${dg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function sw(){return fl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:fg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function rw(){return fl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Qb}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function $m(){return fl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Xm(){return fl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function aw(i){let e=new WeakMap,t=new WeakMap,n=null;function s(f,p=!1){return f==null?null:p?a(f):r(f)}function r(f){if(f&&f.isTexture){let p=f.mapping;if(p===$c||p===Xc)if(e.has(f)){let g=e.get(f).texture;return o(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let _=new dl(g.height);return _.fromEquirectangularTexture(i,f),e.set(f,_),f.addEventListener("dispose",c),o(_.texture,f.mapping)}else return null}}return f}function a(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let p=f.mapping,g=p===$c||p===Xc,_=p===Ur||p===Ba;if(g||_){let m=t.get(f),v=m!==void 0?m.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==v)return n===null&&(n=new Dh(i)),m=g?n.fromEquirectangular(f,m):n.fromCubemap(f,m),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),m.texture;if(m!==void 0)return m.texture;{let x=f.image;return g&&x&&x.height>0||_&&x&&l(x)?(n===null&&(n=new Dh(i)),m=g?n.fromEquirectangular(f):n.fromCubemap(f),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),f.addEventListener("dispose",u),m.texture):null}}}return f}function o(f,p){return p===$c?f.mapping=Ur:p===Xc&&(f.mapping=Ba),f}function l(f){let p=0,g=6;for(let _=0;_<g;_++)f[_]!==void 0&&p++;return p===g}function c(f){let p=f.target;p.removeEventListener("dispose",c);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function u(f){let p=f.target;p.removeEventListener("dispose",u);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function ow(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&To("WebGLRenderer: "+n+" extension not supported."),s}}}function lw(i,e,t,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let _=r.get(g);_&&(e.remove(_),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,_){return s[_.id]!==void 0||(_.addEventListener("dispose",o),s[_.id]=new WeakRef(_),a.register(_,_.id,_),t.memory.geometries++),_}function u(g){let _=g.attributes;for(let m in _)e.update(_[m],i.ARRAY_BUFFER)}function d(g){let _=g.index,m=g.attributes.position,v=0;if(m===void 0)return;let x=_!==null?_.array.length:m.array.length/3-1,S=m.count>=65535?Bo:Oo,y=new S(Math.ceil(x/3)*6,1),T=y.array;if(_!==null){let b=_.array;v=_.version;for(let A=0,O=0;A<x;A+=3){let N=b[A+0],P=b[A+1],k=b[A+2];T[O++]=N,T[O++]=P,T[O++]=P,T[O++]=k,T[O++]=k,T[O++]=N}}else{v=m.version;for(let b=0,A=0;b<x;b+=3){let O=b+0,N=b+1,P=b+2;T[A++]=O,T[A++]=N,T[A++]=N,T[A++]=P,T[A++]=P,T[A++]=O}}y.version=v;let M=r.get(g);M&&e.remove(M),r.set(g,y)}function f(g){let _=r.get(g);if(_){let m=g.index;m!==null&&_.version<m.version&&d(g)}else d(g);return r.get(g)}function p(){for(let g in s){let _=s[g].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:f,dispose:p}}function cw(i,e,t){let n;function s(d){n=d}let r,a;function o(d){r=d.type,a=d.bytesPerElement}function l(d,f){i.drawElements(n,f,r,d*a),t.update(f,n,1)}function c(d,f,p){p!==0&&(i.drawElementsInstanced(n,f,r,d*a,p),t.update(f,n,p))}function u(d,f,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,d,0,p);let _=0;for(let m=0;m<p;m++)_+=f[m];t.update(_,n,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function hw(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(t.calls++,a){case i.TRIANGLES:t.triangles+=o*(r/3);break;case i.LINES:t.lines+=o*(r/2);break;case i.LINE_STRIP:t.lines+=o*(r-1);break;case i.LINE_LOOP:t.lines+=o*r;break;case i.POINTS:t.points+=o*r;break;default:ot("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function uw(i,e,t){let n=new WeakMap,s=new tn;function r(a,o,l){let c=a.morphTargetInfluences,u=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,d=u!==void 0?u.length:0,f=n.get(o);if(f===void 0||f.count!==d){let O=function(){b.dispose(),n.delete(o),o.removeEventListener("dispose",O)};f!==void 0&&f.texture.dispose();let p=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,_=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],v=o.morphAttributes.normal||[],x=o.morphAttributes.color||[],S=0;p===!0&&(S=1),g===!0&&(S=2),_===!0&&(S=3);let y=o.attributes.position.count*S,T=1;y>e.maxTextureSize&&(T=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);let M=new Float32Array(y*T*4*d),b=new ko(M,y,T,d);b.type=Yi,b.needsUpdate=!0;let A=S*4;for(let N=0;N<d;N++){let P=m[N],k=v[N],B=x[N],L=y*T*4*N;for(let H=0;H<P.count;H++){let Y=H*A;p===!0&&(s.fromBufferAttribute(P,H),M[L+Y+0]=s.x,M[L+Y+1]=s.y,M[L+Y+2]=s.z,M[L+Y+3]=0),g===!0&&(s.fromBufferAttribute(k,H),M[L+Y+4]=s.x,M[L+Y+5]=s.y,M[L+Y+6]=s.z,M[L+Y+7]=0),_===!0&&(s.fromBufferAttribute(B,H),M[L+Y+8]=s.x,M[L+Y+9]=s.y,M[L+Y+10]=s.z,M[L+Y+11]=B.itemSize===4?s.w:1)}}f={count:d,texture:b,size:new Ge(y,T)},n.set(o,f),o.addEventListener("dispose",O)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,t);else{let p=0;for(let _=0;_<c.length;_++)p+=c[_];let g=o.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function dw(i,e,t,n,s){let r=new WeakMap;function a(c){let u=s.render.frame,d=c.geometry,f=e.get(c,d);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return f}function o(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:a,dispose:o}}var fw={[vd]:"LINEAR_TONE_MAPPING",[_d]:"REINHARD_TONE_MAPPING",[yd]:"CINEON_TONE_MAPPING",[xd]:"ACES_FILMIC_TONE_MAPPING",[wd]:"AGX_TONE_MAPPING",[Sd]:"NEUTRAL_TONE_MAPPING",[bd]:"CUSTOM_TONE_MAPPING"};function pw(i,e,t,n,s,r){let a=new bi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,u=new fn;u.setAttribute("position",new Xt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Xt([0,2,0,0,2,0],2));let d=new Rc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new hn(u,d),p=new Nr(-1,1,1,-1,0,1),g=null,_=null,m=!1,v,x=null,S=[],y=!1;this.setSize=function(T,M){a.setSize(T,M),o!==null&&o.setSize(T,M),l!==null&&l.setSize(T,M);for(let b=0;b<S.length;b++){let A=S[b];A.setSize&&A.setSize(T,M)}},this.setEffects=function(T){S=T,y=S.length>0&&S[0].isRenderPass===!0;let M=a.width,b=a.height;S.length>0&&o===null&&(o=new bi(M,b,{type:Zi,depthBuffer:!1,stencilBuffer:!1}),l=new bi(M,b,{type:Zi,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&S.some(O=>O.needsDepthTexture===!0);A!==(a.depthTexture!==null)&&(A===!0&&c===null&&(c=new Ns(M,b),r===!0&&(c.format=Us,c.type=Or)),a.dispose(),a.depthTexture=A?c:null,a.resolveDepthBuffer=A,a.storeMultisampledDepthBuffer=A);for(let O=0;O<S.length;O++){let N=S[O];N.setSize&&N.setSize(M,b),A&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(T,M){if(m||T.toneMapping===fs&&S.length===0)return!1;if(x=M,M!==null){let b=M.width,A=M.height;(a.width!==b||a.height!==A)&&this.setSize(b,A)}return y===!1&&T.setRenderTarget(a),v=T.toneMapping,T.toneMapping=fs,!0},this.hasRenderPass=function(){return y},this.end=function(T,M){T.toneMapping=v,m=!0;let b=a,A=o;for(let O=0;O<S.length;O++){let N=S[O];N.enabled!==!1&&(N.render(T,A,b,M),N.needsSwap!==!1&&(b=A,A=A===o?l:o))}if(g!==T.outputColorSpace||_!==T.toneMapping){g=T.outputColorSpace,_=T.toneMapping,d.defines={},Mt.getTransfer(g)===Nt&&(d.defines.SRGB_TRANSFER="");let O=fw[_];O&&(d.defines[O]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=b.texture,T.setRenderTarget(x),T.render(f,p),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),u.dispose(),d.dispose()}}var pg=new ri,mg=new Ns(1,1),gg=new Go(1),vg=new ko,_g=new gc,yg=new Vo,qm=[],Ym=[],Zm=new Float32Array(16),Km=new Float32Array(9),jm=new Float32Array(4);function Ha(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=qm[s];if(r===void 0&&(r=new Float32Array(s),qm[s]=r),e!==0){n.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,i[a].toArray(r,o)}return r}function wn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Sn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function kh(i,e){let t=Ym[e];t===void 0&&(t=new Int32Array(e),Ym[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function mw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function gw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;i.uniform2fv(this.addr,e),Sn(t,e)}}function vw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(wn(t,e))return;i.uniform3fv(this.addr,e),Sn(t,e)}}function _w(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;i.uniform4fv(this.addr,e),Sn(t,e)}}function yw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(wn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Sn(t,e)}else{if(wn(t,n))return;jm.set(n),i.uniformMatrix2fv(this.addr,!1,jm),Sn(t,n)}}function xw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(wn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Sn(t,e)}else{if(wn(t,n))return;Km.set(n),i.uniformMatrix3fv(this.addr,!1,Km),Sn(t,n)}}function bw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(wn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Sn(t,e)}else{if(wn(t,n))return;Zm.set(n),i.uniformMatrix4fv(this.addr,!1,Zm),Sn(t,n)}}function ww(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function Sw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;i.uniform2iv(this.addr,e),Sn(t,e)}}function Mw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wn(t,e))return;i.uniform3iv(this.addr,e),Sn(t,e)}}function Ew(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;i.uniform4iv(this.addr,e),Sn(t,e)}}function Tw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function Aw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;i.uniform2uiv(this.addr,e),Sn(t,e)}}function Cw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wn(t,e))return;i.uniform3uiv(this.addr,e),Sn(t,e)}}function Rw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;i.uniform4uiv(this.addr,e),Sn(t,e)}}function Fh(i){return i.version===0&&(i.compareFunction=Nd,i.needsUpdate=!0),i}function Pw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Fh(mg):r=pg,t.setTexture2D(e||r,s)}function Lw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||_g,s)}function Iw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Fh(gg):r=yg,t.setTextureCube(e||r,s)}function Dw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||vg,s)}function Nw(i){switch(i){case 5126:return mw;case 35664:return gw;case 35665:return vw;case 35666:return _w;case 35674:return yw;case 35675:return xw;case 35676:return bw;case 5124:case 35670:return ww;case 35667:case 35671:return Sw;case 35668:case 35672:return Mw;case 35669:case 35673:return Ew;case 5125:return Tw;case 36294:return Aw;case 36295:return Cw;case 36296:return Rw;case 35678:case 36198:case 36298:case 36306:case 35682:return Pw;case 35679:case 36299:case 36307:return Lw;case 35680:case 36300:case 36308:case 36293:return Iw;case 36289:case 36303:case 36311:case 36292:return Dw}}function kw(i,e){i.uniform1fv(this.addr,e)}function Fw(i,e){let t=Ha(e,this.size,2);i.uniform2fv(this.addr,t)}function Uw(i,e){let t=Ha(e,this.size,3);i.uniform3fv(this.addr,t)}function Ow(i,e){let t=Ha(e,this.size,4);i.uniform4fv(this.addr,t)}function Bw(i,e){let t=Ha(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function zw(i,e){let t=Ha(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function Vw(i,e){let t=Ha(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Gw(i,e){i.uniform1iv(this.addr,e)}function Hw(i,e){i.uniform2iv(this.addr,e)}function Ww(i,e){i.uniform3iv(this.addr,e)}function $w(i,e){i.uniform4iv(this.addr,e)}function Xw(i,e){i.uniform1uiv(this.addr,e)}function qw(i,e){i.uniform2uiv(this.addr,e)}function Yw(i,e){i.uniform3uiv(this.addr,e)}function Zw(i,e){i.uniform4uiv(this.addr,e)}function Kw(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);wn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Fh(mg):a=pg;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function jw(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);wn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||_g,r[a])}function Jw(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);wn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Fh(gg):a=yg;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function Qw(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);wn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||vg,r[a])}function eS(i){switch(i){case 5126:return kw;case 35664:return Fw;case 35665:return Uw;case 35666:return Ow;case 35674:return Bw;case 35675:return zw;case 35676:return Vw;case 5124:case 35670:return Gw;case 35667:case 35671:return Hw;case 35668:case 35672:return Ww;case 35669:case 35673:return $w;case 5125:return Xw;case 36294:return qw;case 36295:return Yw;case 36296:return Zw;case 35678:case 36198:case 36298:case 36306:case 35682:return Kw;case 35679:case 36299:case 36307:return jw;case 35680:case 36300:case 36308:case 36293:return Jw;case 36289:case 36303:case 36311:case 36292:return Qw}}var Yd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Nw(t.type)}},Zd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=eS(t.type)}},Kd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(e,t[o.id],n)}}},Xd=/(\w+)(\])?(\[|\.)?/g;function Jm(i,e){i.seq.push(e),i.map[e.id]=e}function tS(i,e,t){let n=i.name,s=n.length;for(Xd.lastIndex=0;;){let r=Xd.exec(n),a=Xd.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Jm(t,c===void 0?new Yd(o,i,e):new Zd(o,i,e));break}else{let d=t.map[o];d===void 0&&(d=new Kd(o),Jm(t,d)),t=d}}}var Ga=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);tS(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,a=t.length;r!==a;++r){let o=t[r],l=n[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let a=e[s];a.id in t&&n.push(a)}return n}};function Qm(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var nS=37297,iS=0;function sS(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return n.join(`
`)}var eg=new lt;function rS(i){Mt._getMatrix(eg,Mt.workingColorSpace,i);let e=`mat3( ${eg.elements.map(t=>t.toFixed(4))} )`;switch(Mt.getTransfer(i)){case Do:return[e,"LinearTransferOETF"];case Nt:return[e,"sRGBTransferOETF"];default:return Je("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function tg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+sS(i.getShaderSource(e),o)}else return r}function aS(i,e){let t=rS(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var oS={[vd]:"Linear",[_d]:"Reinhard",[yd]:"Cineon",[xd]:"ACESFilmic",[wd]:"AgX",[Sd]:"Neutral",[bd]:"Custom"};function lS(i,e){let t=oS[e];return t===void 0?(Je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ih=new G;function cS(){Mt.getLuminanceCoefficients(Ih);let i=Ih.x.toFixed(4),e=Ih.y.toFixed(4),t=Ih.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function hS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ul).join(`
`)}function uS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function dS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:i.getAttribLocation(e,a),locationSize:o}}return t}function ul(i){return i!==""}function ng(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function ig(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var fS=/^[ \t]*#include +<([\w\d./]+)>/gm;function jd(i){return i.replace(fS,pS)}function pS(i,e){let t=gt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return jd(t)}var mS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function sg(i){return i.replace(mS,gS)}function gS(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function rg(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var vS={[nl]:"SHADOWMAP_TYPE_PCF",[Ua]:"SHADOWMAP_TYPE_VSM"};function _S(i){return vS[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var yS={[Ba]:"ENVMAP_MODE_REFRACTION"};function xS(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":yS[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var bS={[Wc]:"ENVMAP_BLENDING_MULTIPLY",[bm]:"ENVMAP_BLENDING_MIX",[wm]:"ENVMAP_BLENDING_ADD"};function wS(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":bS[i.combine]||"ENVMAP_BLENDING_NONE"}function SS(i,e,t,n){let s=i.getContext(),r=t.defines,a=t.vertexShader,o=t.fragmentShader,l=_S(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=xS(t),d=wS(t),f=hS(t),p=uS(r),g=s.createProgram(),_,m,v=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(ul).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(ul).join(`
`),m.length>0&&(m+=`
`)):(_=[rg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ul).join(`
`),m=[rg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==fs?"#define TONE_MAPPING":"",t.toneMapping!==fs?gt.tonemapping_pars_fragment:"",t.toneMapping!==fs?lS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",gt.colorspace_pars_fragment,aS("linearToOutputTexel",t.outputColorSpace),cS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ul).join(`
`)),a=jd(a),a=ng(a,t),a=ig(a,t),o=jd(o),o=ng(o,t),o=ig(o,t),a=sg(a),o=sg(o),t.isRawShaderMaterial!==!0&&(v=`#version 300 es
`,_=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",t.glslVersion===kd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===kd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=v+_+a,S=v+m+o,y=Qm(s,s.VERTEX_SHADER,x),T=Qm(s,s.FRAGMENT_SHADER,S);s.attachShader(g,y),s.attachShader(g,T),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function M(N){if(i.debug.checkShaderErrors){let P=s.getProgramInfoLog(g)||"",k=s.getShaderInfoLog(y)||"",B=s.getShaderInfoLog(T)||"",L=P.trim(),H=k.trim(),Y=B.trim(),$=!0,ce=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if($=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,y,T);else{let K=tg(s,y,"vertex"),ee=tg(s,T,"fragment");ot("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+L+`
`+K+`
`+ee)}else L!==""?Je("WebGLProgram: Program Info Log:",L):(H===""||Y==="")&&(ce=!1);ce&&(N.diagnostics={runnable:$,programLog:L,vertexShader:{log:H,prefix:_},fragmentShader:{log:Y,prefix:m}})}s.deleteShader(y),s.deleteShader(T),b=new Ga(s,g),A=dS(s,g)}let b;this.getUniforms=function(){return b===void 0&&M(this),b};let A;this.getAttributes=function(){return A===void 0&&M(this),A};let O=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(g,nS)),O},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=iS++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=y,this.fragmentShader=T,this}var MS=0,Jd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Qd(e),t.set(e,n)),n}},Qd=class{constructor(e){this.id=MS++,this.code=e,this.usedTimes=0}};function ES(i){return i===ur||i===ll||i===cl}function TS(i,e,t,n,s,r){let a=new Fo,o=new Jd,l=new Set,c=[],u=new Map,d=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(b){return l.add(b),b===0?"uv":`uv${b}`}function g(b,A,O,N,P,k){let B=N.fog,L=P.geometry,H=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?N.environment:null,Y=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap,$=e.get(b.envMap||H,Y),ce=f[b.type],K=n.precision;b.precision!==null&&(K=n.getMaxPrecision(b.precision),K!==b.precision&&Je("WebGLProgram.getParameters:",b.precision,"not supported, using",K,"instead."));let ee=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,ne=ee!==void 0?ee.length:0,ue=0;L.morphAttributes.position!==void 0&&(ue=1),L.morphAttributes.normal!==void 0&&(ue=2),L.morphAttributes.color!==void 0&&(ue=3);let de,Q,ge,ye;if(ce){let De=ms[ce];de=De.vertexShader,Q=De.fragmentShader}else{de=b.vertexShader,Q=b.fragmentShader;let De=o.getVertexShaderStage(b),ft=o.getFragmentShaderStage(b);o.update(b,De,ft),ge=De.id,ye=ft.id}let Te=i.getRenderTarget(),be=i.state.buffers.depth.getReversed(),Ye=P.isInstancedMesh===!0,he=P.isBatchedMesh===!0,Ie=!!b.map,rt=!!b.matcap,dt=!!$,qe=dt&&$.isPMREMTexture===!0,Ft=!!b.aoMap,Rt=!!b.lightMap,Wt=!!b.bumpMap&&b.wireframe===!1,Tt=!!b.normalMap,Dt=!!b.displacementMap,ut=!!b.emissiveMap,nn=!!b.metalnessMap,rn=!!b.roughnessMap,pn=b.anisotropy>0,V=b.clearcoat>0,Ne=b.diffuseRoughness>0,tt=b.dispersion>0,ht=b.retroreflectivity>0,Ce=b.iridescence>0,Vt=b.sheen>0,Xe=b.transmission>0,je=pn&&!!b.anisotropyMap,I=V&&!!b.clearcoatMap,E=V&&!!b.clearcoatNormalMap,q=V&&!!b.clearcoatRoughnessMap,pe=Ne&&!!b.diffuseRoughnessMap,oe=Ce&&!!b.iridescenceMap,Se=Ce&&!!b.iridescenceThicknessMap,Me=Vt&&!!b.sheenColorMap,ie=Vt&&!!b.sheenRoughnessMap,re=!!b.specularMap,_e=!!b.specularColorMap,z=!!b.specularIntensityMap,ae=Xe&&!!b.transmissionMap,se=Xe&&!!b.thicknessMap,Re=!!b.gradientMap,we=!!b.alphaMap,Ae=b.alphaTest>0,Ze=!!b.alphaHash,it=!!b.extensions,fe=fs;b.toneMapped&&(Te===null||Te.isXRRenderTarget===!0)&&(fe=i.toneMapping);let He=qe?$.isCompressedCubeTexture?$.image[0].mipmaps:$.mipmaps:null,st={shaderID:ce,shaderType:b.type,shaderName:b.name,vertexShader:de,fragmentShader:Q,defines:b.defines,customVertexShaderID:ge,customFragmentShaderID:ye,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:K,batching:he,batchingColor:he&&P._colorsTexture!==null,instancing:Ye,instancingColor:Ye&&P.instanceColor!==null,instancingMorph:Ye&&P.morphTexture!==null,outputColorSpace:Te===null?i.outputColorSpace:Te.isXRRenderTarget===!0?Te.texture.colorSpace:Mt.workingColorSpace,alphaToCoverage:!!b.alphaToCoverage,map:Ie,matcap:rt,envMap:dt,envMapMode:dt&&$.mapping,envMapPMREM:qe,envMapMaxLod:qe?He.length-1:null,envMapSize:qe?He[0].width:null,aoMap:Ft,lightMap:Rt,bumpMap:Wt,normalMap:Tt,displacementMap:Dt,emissiveMap:ut,normalMapObjectSpace:Tt&&b.normalMapType===Em,normalMapTangentSpace:Tt&&b.normalMapType===Ph,packedNormalMap:Tt&&b.normalMapType===Ph&&ES(b.normalMap.format),metalnessMap:nn,roughnessMap:rn,anisotropy:pn,anisotropyMap:je,clearcoat:V,clearcoatMap:I,clearcoatNormalMap:E,clearcoatRoughnessMap:q,diffuseRoughness:Ne,diffuseRoughnessMap:pe,dispersion:tt,retroreflection:ht,iridescence:Ce,iridescenceMap:oe,iridescenceThicknessMap:Se,sheen:Vt,sheenColorMap:Me,sheenRoughnessMap:ie,specularMap:re,specularColorMap:_e,specularIntensityMap:z,transmission:Xe,transmissionMap:ae,thicknessMap:se,gradientMap:Re,opaque:b.transparent===!1&&b.blending===Oa&&b.alphaToCoverage===!1,alphaMap:we,alphaTest:Ae,alphaHash:Ze,combine:b.combine,mapUv:Ie&&p(b.map.channel),aoMapUv:Ft&&p(b.aoMap.channel),lightMapUv:Rt&&p(b.lightMap.channel),bumpMapUv:Wt&&p(b.bumpMap.channel),normalMapUv:Tt&&p(b.normalMap.channel),displacementMapUv:Dt&&p(b.displacementMap.channel),emissiveMapUv:ut&&p(b.emissiveMap.channel),metalnessMapUv:nn&&p(b.metalnessMap.channel),roughnessMapUv:rn&&p(b.roughnessMap.channel),anisotropyMapUv:je&&p(b.anisotropyMap.channel),clearcoatMapUv:I&&p(b.clearcoatMap.channel),clearcoatNormalMapUv:E&&p(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&p(b.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:pe&&p(b.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&p(b.iridescenceMap.channel),iridescenceThicknessMapUv:Se&&p(b.iridescenceThicknessMap.channel),sheenColorMapUv:Me&&p(b.sheenColorMap.channel),sheenRoughnessMapUv:ie&&p(b.sheenRoughnessMap.channel),specularMapUv:re&&p(b.specularMap.channel),specularColorMapUv:_e&&p(b.specularColorMap.channel),specularIntensityMapUv:z&&p(b.specularIntensityMap.channel),transmissionMapUv:ae&&p(b.transmissionMap.channel),thicknessMapUv:se&&p(b.thicknessMap.channel),alphaMapUv:we&&p(b.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(Tt||pn),vertexNormals:!!L.attributes.normal,vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!L.attributes.uv&&(Ie||we),fog:!!B,useFog:b.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:b.wireframe===!1&&(b.flatShading===!0||L.attributes.normal===void 0&&Tt===!1&&(b.isMeshLambertMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isMeshPhysicalMaterial)),sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:be,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:ue,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:k.filter(De=>De.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:b.dithering,shadowMapEnabled:i.shadowMap.enabled&&O.length>0,shadowMapType:i.shadowMap.type,toneMapping:fe,decodeVideoTexture:Ie&&b.map.isVideoTexture===!0&&Mt.getTransfer(b.map.colorSpace)===Nt,decodeVideoTextureEmissive:ut&&b.emissiveMap.isVideoTexture===!0&&Mt.getTransfer(b.emissiveMap.colorSpace)===Nt,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===ai,flipSided:b.side===ti,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:it&&b.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(it&&b.extensions.multiDraw===!0||he)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return st.vertexUv1s=l.has(1),st.vertexUv2s=l.has(2),st.vertexUv3s=l.has(3),l.clear(),st}function _(b){let A=[];if(b.shaderID?A.push(b.shaderID):(A.push(b.customVertexShaderID),A.push(b.customFragmentShaderID)),b.defines!==void 0)for(let O in b.defines)A.push(O),A.push(b.defines[O]);return b.isRawShaderMaterial===!1&&(m(A,b),v(A,b),A.push(i.outputColorSpace)),A.push(b.customProgramCacheKey),A.join()}function m(b,A){b.push(A.precision),b.push(A.outputColorSpace),b.push(A.envMapMode),b.push(A.envMapPMREM),b.push(A.envMapMaxLod),b.push(A.envMapSize),b.push(A.mapUv),b.push(A.alphaMapUv),b.push(A.lightMapUv),b.push(A.aoMapUv),b.push(A.bumpMapUv),b.push(A.normalMapUv),b.push(A.displacementMapUv),b.push(A.emissiveMapUv),b.push(A.metalnessMapUv),b.push(A.roughnessMapUv),b.push(A.anisotropyMapUv),b.push(A.clearcoatMapUv),b.push(A.clearcoatNormalMapUv),b.push(A.clearcoatRoughnessMapUv),b.push(A.diffuseRoughnessMapUv),b.push(A.iridescenceMapUv),b.push(A.iridescenceThicknessMapUv),b.push(A.sheenColorMapUv),b.push(A.sheenRoughnessMapUv),b.push(A.specularMapUv),b.push(A.specularColorMapUv),b.push(A.specularIntensityMapUv),b.push(A.transmissionMapUv),b.push(A.thicknessMapUv),b.push(A.combine),b.push(A.fogExp2),b.push(A.sizeAttenuation),b.push(A.morphTargetsCount),b.push(A.numSunLights),b.push(A.numDirLights),b.push(A.numPointLights),b.push(A.numSpotLights),b.push(A.numSpotLightMaps),b.push(A.numHemiLights),b.push(A.numRectAreaLights),b.push(A.numSunLightShadows),b.push(A.numDirLightShadows),b.push(A.numPointLightShadows),b.push(A.numSpotLightShadows),b.push(A.numSpotLightShadowsWithMaps),b.push(A.numLightProbes),b.push(A.numLightProbeGrids),b.push(A.shadowMapType),b.push(A.toneMapping),b.push(A.numClippingPlanes),b.push(A.numClipIntersection),b.push(A.depthPacking)}function v(b,A){a.disableAll(),A.instancing&&a.enable(0),A.instancingColor&&a.enable(1),A.instancingMorph&&a.enable(2),A.matcap&&a.enable(3),A.envMap&&a.enable(4),A.normalMapObjectSpace&&a.enable(5),A.normalMapTangentSpace&&a.enable(6),A.clearcoat&&a.enable(7),A.iridescence&&a.enable(8),A.alphaTest&&a.enable(9),A.vertexColors&&a.enable(10),A.vertexAlphas&&a.enable(11),A.vertexUv1s&&a.enable(12),A.vertexUv2s&&a.enable(13),A.vertexUv3s&&a.enable(14),A.vertexTangents&&a.enable(15),A.anisotropy&&a.enable(16),A.alphaHash&&a.enable(17),A.batching&&a.enable(18),A.dispersion&&a.enable(19),A.retroreflection&&a.enable(24),A.diffuseRoughness&&a.enable(25),A.batchingColor&&a.enable(20),A.gradientMap&&a.enable(21),A.packedNormalMap&&a.enable(22),A.vertexNormals&&a.enable(23),b.push(a.mask),a.disableAll(),A.fog&&a.enable(0),A.useFog&&a.enable(1),A.flatShading&&a.enable(2),A.logarithmicDepthBuffer&&a.enable(3),A.reversedDepthBuffer&&a.enable(4),A.skinning&&a.enable(5),A.morphTargets&&a.enable(6),A.morphNormals&&a.enable(7),A.morphColors&&a.enable(8),A.premultipliedAlpha&&a.enable(9),A.shadowMapEnabled&&a.enable(10),A.doubleSided&&a.enable(11),A.flipSided&&a.enable(12),A.useDepthPacking&&a.enable(13),A.dithering&&a.enable(14),A.transmission&&a.enable(15),A.sheen&&a.enable(16),A.opaque&&a.enable(17),A.pointsUvs&&a.enable(18),A.decodeVideoTexture&&a.enable(19),A.decodeVideoTextureEmissive&&a.enable(20),A.alphaToCoverage&&a.enable(21),A.numLightProbeGrids>0&&a.enable(22),A.hasPositionAttribute&&a.enable(23),b.push(a.mask)}function x(b){let A=f[b.type],O;if(A){let N=ms[A];O=zm.clone(N.uniforms)}else O=b.uniforms;return O}function S(b,A){let O=u.get(A);return O!==void 0?++O.usedTimes:(O=new SS(i,A,b,s),c.push(O),u.set(A,O)),O}function y(b){if(--b.usedTimes===0){let A=c.indexOf(b);c[A]=c[c.length-1],c.pop(),u.delete(b.cacheKey),b.destroy()}}function T(b){o.remove(b)}function M(){o.dispose()}return{getParameters:g,getProgramCacheKey:_,getUniforms:x,acquireProgram:S,releaseProgram:y,releaseShaderCache:T,programs:c,dispose:M}}function AS(){let i=new WeakMap;function e(a){return i.has(a)}function t(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,l){i.get(a)[o]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function CS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function ag(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function og(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function a(f){let p=0;return f.isInstancedMesh&&(p+=2),f.isSkinnedMesh&&(p+=1),p}function o(f,p,g,_,m,v){let x=i[e];return x===void 0?(x={id:f.id,object:f,geometry:p,material:g,materialVariant:a(f),groupOrder:_,renderOrder:f.renderOrder,z:m,group:v},i[e]=x):(x.id=f.id,x.object=f,x.geometry=p,x.material=g,x.materialVariant=a(f),x.groupOrder=_,x.renderOrder=f.renderOrder,x.z=m,x.group=v),e++,x}function l(f,p,g,_,m,v,x){x.reversedDepth===!0&&(m=-m);let S=o(f,p,g,_,m,v);g.transmission>0?n.push(S):g.transparent===!0?s.push(S):t.push(S)}function c(f,p,g,_,m,v){let x=o(f,p,g,_,m,v);g.transmission>0?n.unshift(x):g.transparent===!0?s.unshift(x):t.unshift(x)}function u(f,p){t.length>1&&t.sort(f||CS),n.length>1&&n.sort(p||ag),s.length>1&&s.sort(p||ag)}function d(){for(let f=e,p=i.length;f<p;f++){let g=i[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function RS(){let i=new WeakMap;function e(n,s){let r=i.get(n),a;return r===void 0?(a=new og,i.set(n,[a])):s>=r.length?(a=new og,r.push(a)):a=r[s],a}function t(){i=new WeakMap}return{get:e,dispose:t}}function PS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new G,color:new Qe};break;case"SpotLight":t={position:new G,direction:new G,color:new Qe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new G,color:new Qe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new G,skyColor:new Qe,groundColor:new Qe};break;case"RectAreaLight":t={color:new Qe,position:new G,halfWidth:new G,halfHeight:new G};break}return i[e.id]=t,t}}}function LS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var IS=0;function DS(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function NS(i){let e=new PS,t=LS(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new G);let s=new G,r=new $t,a=new $t;function o(c){let u=0,d=0,f=0;for(let k=0;k<9;k++)n.probe[k].set(0,0,0);let p=0,g=0,_=0,m=0,v=0,x=0,S=0,y=0,T=0,M=0,b=0,A=0,O=0,N=0;c.sort(DS);for(let k=0,B=c.length;k<B;k++){let L=c[k],H=L.color,Y=L.intensity,$=L.distance,ce=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===ur?ce=L.shadow.map.texture:ce=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)u+=H.r*Y,d+=H.g*Y,f+=H.b*Y;else if(L.isLightProbe){for(let K=0;K<9;K++)n.probe[K].addScaledVector(L.sh.coefficients[K],Y);N++}else if(L.isSunLight){let K=e.get(L);if(K.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let ee=L.shadow,ne=t.get(L);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),n.sunShadow[g]=ne,n.sunShadowMap[g]=ce;let ue=ee.getViewportCount();for(let de=0;de<ue;de++)n.sunShadowMatrix[_+de]=ee.getMatrix(de),n.sunShadowCascade[_+de]=ee._cascadeData[de];_+=ue,g++}n.sun[p]=K,p++}else if(L.isDirectionalLight){let K=e.get(L);if(K.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let ee=L.shadow,ne=t.get(L);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize=ee.mapSize,n.directionalShadow[m]=ne,n.directionalShadowMap[m]=ce,n.directionalShadowMatrix[m]=L.shadow.matrix,T++}n.directional[m]=K,m++}else if(L.isSpotLight){let K=e.get(L);K.position.setFromMatrixPosition(L.matrixWorld),K.color.copy(H).multiplyScalar(Y),K.distance=$,K.coneCos=Math.cos(L.angle),K.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),K.decay=L.decay,n.spot[x]=K;let ee=L.shadow;if(L.map&&(n.spotLightMap[A]=L.map,A++,ee.updateMatrices(L),L.castShadow&&O++),n.spotLightMatrix[x]=ee.matrix,L.castShadow){let ne=t.get(L);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize=ee.mapSize,n.spotShadow[x]=ne,n.spotShadowMap[x]=ce,b++}x++}else if(L.isRectAreaLight){let K=e.get(L);K.color.copy(H).multiplyScalar(Y),K.halfWidth.set(L.width*.5,0,0),K.halfHeight.set(0,L.height*.5,0),n.rectArea[S]=K,S++}else if(L.isPointLight){let K=e.get(L);if(K.color.copy(L.color).multiplyScalar(L.intensity),K.distance=L.distance,K.decay=L.decay,L.castShadow){let ee=L.shadow,ne=t.get(L);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize=ee.mapSize,ne.shadowCameraNear=ee.camera.near,ne.shadowCameraFar=ee.camera.far,n.pointShadow[v]=ne,n.pointShadowMap[v]=ce,n.pointShadowMatrix[v]=L.shadow.matrix,M++}n.point[v]=K,v++}else if(L.isHemisphereLight){let K=e.get(L);K.skyColor.copy(L.color).multiplyScalar(Y),K.groundColor.copy(L.groundColor).multiplyScalar(Y),n.hemi[y]=K,y++}}S>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ue.LTC_FLOAT_1,n.rectAreaLTC2=Ue.LTC_FLOAT_2):(n.rectAreaLTC1=Ue.LTC_HALF_1,n.rectAreaLTC2=Ue.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=d,n.ambient[2]=f;let P=n.hash;(P.sunLength!==p||P.directionalLength!==m||P.pointLength!==v||P.spotLength!==x||P.rectAreaLength!==S||P.hemiLength!==y||P.numSunShadows!==g||P.numDirectionalShadows!==T||P.numPointShadows!==M||P.numSpotShadows!==b||P.numSpotMaps!==A||P.numLightProbes!==N)&&(n.sun.length=p,n.directional.length=m,n.spot.length=x,n.rectArea.length=S,n.point.length=v,n.hemi.length=y,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=_,n.sunShadowCascade.length=_,n.directionalShadow.length=T,n.directionalShadowMap.length=T,n.directionalShadowMatrix.length=T,n.pointShadow.length=M,n.pointShadowMap.length=M,n.pointShadowMatrix.length=M,n.spotShadow.length=b,n.spotShadowMap.length=b,n.spotLightMatrix.length=b+A-O,n.spotLightMap.length=A,n.numSpotLightShadowsWithMaps=O,n.numLightProbes=N,P.sunLength=p,P.directionalLength=m,P.pointLength=v,P.spotLength=x,P.rectAreaLength=S,P.hemiLength=y,P.numSunShadows=g,P.numDirectionalShadows=T,P.numPointShadows=M,P.numSpotShadows=b,P.numSpotMaps=A,P.numLightProbes=N,n.version=IS++)}function l(c,u){let d=0,f=0,p=0,g=0,_=0,m=0,v=u.matrixWorldInverse;for(let x=0,S=c.length;x<S;x++){let y=c[x];if(y.isSunLight){let T=n.sun[d];T.direction.setFromMatrixPosition(y.matrixWorld),T.direction.transformDirection(v),d++}else if(y.isDirectionalLight){let T=n.directional[f];T.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(v),f++}else if(y.isSpotLight){let T=n.spot[g];T.position.setFromMatrixPosition(y.matrixWorld),T.position.applyMatrix4(v),T.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(v),g++}else if(y.isRectAreaLight){let T=n.rectArea[_];T.position.setFromMatrixPosition(y.matrixWorld),T.position.applyMatrix4(v),a.identity(),r.copy(y.matrixWorld),r.premultiply(v),a.extractRotation(r),T.halfWidth.set(y.width*.5,0,0),T.halfHeight.set(0,y.height*.5,0),T.halfWidth.applyMatrix4(a),T.halfHeight.applyMatrix4(a),_++}else if(y.isPointLight){let T=n.point[p];T.position.setFromMatrixPosition(y.matrixWorld),T.position.applyMatrix4(v),p++}else if(y.isHemisphereLight){let T=n.hemi[m];T.direction.setFromMatrixPosition(y.matrixWorld),T.direction.transformDirection(v),m++}}}return{setup:o,setupView:l,state:n}}function lg(i){let e=new NS(i),t=[],n=[],s=[];function r(d){u.camera=d,t.length=0,n.length=0,s.length=0}function a(d){d.isLightProbeGrid?s.push(d):t.push(d)}function o(d){n.push(d)}function l(){e.setup(t),s.sort((d,f)=>d.priority-f.priority||d.id-f.id)}function c(d){e.setupView(t,d)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function kS(i){let e=new WeakMap;function t(s,r=0){let a=e.get(s),o;return a===void 0?(o=new lg(i),e.set(s,[o])):r>=a.length?(o=new lg(i),a.push(o)):o=a[r],o}function n(){e=new WeakMap}return{get:t,dispose:n}}var FS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,US=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,OS=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],BS=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],cg=new $t,hl=new G,qd=new G;function zS(i,e,t){let n=new sr,s=new Ge,r=new Ge,a=new tn,o=new Pc,l=new Lc,c={},u=t.maxTextureSize,d={[hr]:ti,[ti]:hr,[ai]:ai},f=new ds({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ge},radius:{value:4}},vertexShader:FS,fragmentShader:US}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let g=new fn;g.setAttribute("position",new si(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new hn(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=nl;let v=this.type;this.render=function(M,b,A){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||M.length===0)return;this.type===nm&&(Je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=nl);let O=i.getRenderTarget(),N=i.getActiveCubeFace(),P=i.getActiveMipmapLevel(),k=i.state;k.setBlending(kr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let B=v!==this.type;B&&b.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(H=>H.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,H=M.length;L<H;L++){let Y=M[L],$=Y.shadow;if($===void 0){Je("WebGLShadowMap:",Y,"has no shadow.");continue}if($.autoUpdate===!1&&$.needsUpdate===!1)continue;s.copy($.mapSize);let ce=$.getFrameExtents();s.multiply(ce),r.copy($.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ce.x),s.x=r.x*ce.x,$.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ce.y),s.y=r.y*ce.y,$.mapSize.y=r.y));let K=i.state.buffers.depth.getReversed();if($.camera._reversedDepth=K,$.map===null||B===!0){if($.map!==null&&($.map.depthTexture!==null&&($.map.depthTexture.dispose(),$.map.depthTexture=null),$.map.dispose()),this.type===Ua){if(Y.isPointLight){Je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}$.map=new bi(s.x,s.y,{format:ur,type:Zi,minFilter:Jn,magFilter:Jn,generateMipmaps:!1}),$.map.texture.name=Y.name+".shadowMap",$.map.depthTexture=new Ns(s.x,s.y,Yi),$.map.depthTexture.name=Y.name+".shadowMapDepth",$.map.depthTexture.format=Ps,$.map.depthTexture.compareFunction=null,$.map.depthTexture.minFilter=Dn,$.map.depthTexture.magFilter=Dn}else Y.isPointLight?($.map=new dl(s.x),$.map.depthTexture=new Go(s.x,qi)):($.map=new bi(s.x,s.y),$.map.depthTexture=new Ns(s.x,s.y,qi)),$.map.depthTexture.name=Y.name+".shadowMap",$.map.depthTexture.format=Ps,this.type===nl?($.map.depthTexture.compareFunction=K?Dd:Id,$.map.depthTexture.minFilter=Jn,$.map.depthTexture.magFilter=Jn):($.map.depthTexture.compareFunction=null,$.map.depthTexture.minFilter=Dn,$.map.depthTexture.magFilter=Dn);$.camera.updateProjectionMatrix()}$.map.isWebGLCubeRenderTarget!==!0&&($.map.width!==s.x||$.map.height!==s.y)&&$.map.setSize(s.x,s.y);let ee=$.map.isWebGLCubeRenderTarget?6:$.getViewportCount();Y.isPointLight!==!0&&$.updateMatrices(Y,A);let ne=($.camera.layers.mask&4294967294)!==0?$.camera.layers:A.layers;for(let ue=0;ue<ee;ue++){let de=$.getCamera(ue);if(Y.isPointLight){let Q=$.camera,ge=$.matrix,ye=Y.distance||Q.far;ye!==Q.far&&(Q.far=ye,Q.updateProjectionMatrix()),hl.setFromMatrixPosition(Y.matrixWorld),Q.position.copy(hl),qd.copy(Q.position),qd.add(OS[ue]),Q.up.copy(BS[ue]),Q.lookAt(qd),Q.updateMatrixWorld(),ge.makeTranslation(-hl.x,-hl.y,-hl.z),cg.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),$._frustum.setFromProjectionMatrix(cg,Q.coordinateSystem,Q.reversedDepth)}if($.map.isWebGLCubeRenderTarget)i.setRenderTarget($.map,ue),i.clear();else{ue===0&&(i.setRenderTarget($.map),i.clear());let Q=$.getViewport(ue);a.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),k.viewport(a)}n=$.getFrustum(ue),y(b,A,de,Y,ne,this.type)}$.isPointLightShadow!==!0&&this.type===Ua&&x($,A),$.needsUpdate=!1}v=this.type,m.needsUpdate=!1,i.setRenderTarget(O,N,P)};function x(M,b){let A=e.update(_);f.defines.VSM_SAMPLES!==M.blurSamples&&(f.defines.VSM_SAMPLES=M.blurSamples,p.defines.VSM_SAMPLES=M.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),M.mapPass===null?M.mapPass=new bi(s.x,s.y,{format:ur,type:Zi}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),f.uniforms.shadow_pass.value=M.map.depthTexture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,i.setRenderTarget(M.mapPass),i.clear(),i.renderBufferDirect(b,null,A,f,_,null),p.uniforms.shadow_pass.value=M.mapPass.texture,p.uniforms.resolution.value.set(M.map.width,M.map.height),p.uniforms.radius.value=M.radius,i.setRenderTarget(M.map),i.clear(),i.renderBufferDirect(b,null,A,p,_,null)}function S(M,b,A,O){let N=null,P=A.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(P!==void 0)N=P;else if(N=A.isPointLight===!0?l:o,i.localClippingEnabled&&b.clipShadows===!0&&Array.isArray(b.clippingPlanes)&&b.clippingPlanes.length!==0||b.displacementMap&&b.displacementScale!==0||b.alphaMap&&b.alphaTest>0||b.map&&b.alphaTest>0||b.alphaToCoverage===!0){let k=N.uuid,B=b.uuid,L=c[k];L===void 0&&(L={},c[k]=L);let H=L[B];H===void 0&&(H=N.clone(),L[B]=H,b.addEventListener("dispose",T)),N=H}if(N.visible=b.visible,N.wireframe=b.wireframe,O===Ua?N.side=b.shadowSide!==null?b.shadowSide:b.side:N.side=b.shadowSide!==null?b.shadowSide:d[b.side],N.alphaMap=b.alphaMap,N.alphaTest=b.alphaToCoverage===!0?.5:b.alphaTest,N.map=b.map,N.clipShadows=b.clipShadows,N.clippingPlanes=b.clippingPlanes,N.clipIntersection=b.clipIntersection,N.displacementMap=b.displacementMap,N.displacementScale=b.displacementScale,N.displacementBias=b.displacementBias,N.wireframeLinewidth=b.wireframeLinewidth,N.linewidth=b.linewidth,A.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let k=i.properties.get(N);k.light=A}return N}function y(M,b,A,O,N,P){if(M.visible===!1)return;if(M.layers.test(N)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&P===Ua)&&(!M.frustumCulled||M.intersectsFrustum(n))){M.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,M.matrixWorld);let L=e.update(M),H=M.material;if(Array.isArray(H)){let Y=L.groups;for(let $=0,ce=Y.length;$<ce;$++){let K=Y[$],ee=H[K.materialIndex];if(ee&&ee.visible){let ne=S(M,ee,O,P);M.onBeforeShadow(i,M,b,A,L,ne,K),i.renderBufferDirect(A,null,L,ne,M,K),M.onAfterShadow(i,M,b,A,L,ne,K)}}}else if(H.visible){let Y=S(M,H,O,P);M.onBeforeShadow(i,M,b,A,L,Y,null),i.renderBufferDirect(A,null,L,Y,M,null),M.onAfterShadow(i,M,b,A,L,Y,null)}}let B=M.children;for(let L=0,H=B.length;L<H;L++)y(B[L],b,A,O,N,P)}function T(M){M.target.removeEventListener("dispose",T);for(let A in c){let O=c[A],N=M.target.uuid;N in O&&(O[N].dispose(),delete O[N])}}}function VS(i,e){function t(){let z=!1,ae=new tn,se=null,Re=new tn(0,0,0,0);return{setMask:function(we){se!==we&&!z&&(i.colorMask(we,we,we,we),se=we)},setLocked:function(we){z=we},setClear:function(we,Ae,Ze,it,fe){fe===!0&&(we*=it,Ae*=it,Ze*=it),ae.set(we,Ae,Ze,it),Re.equals(ae)===!1&&(i.clearColor(we,Ae,Ze,it),Re.copy(ae))},reset:function(){z=!1,se=null,Re.set(-1,0,0,0)}}}function n(){let z=!1,ae=!1,se=null,Re=null,we=null;return{setReversed:function(Ae){if(ae!==Ae){let Ze=e.get("EXT_clip_control");Ae?Ze.clipControlEXT(Ze.LOWER_LEFT_EXT,Ze.ZERO_TO_ONE_EXT):Ze.clipControlEXT(Ze.LOWER_LEFT_EXT,Ze.NEGATIVE_ONE_TO_ONE_EXT),ae=Ae;let it=we;we=null,this.setClear(it)}},getReversed:function(){return ae},setTest:function(Ae){Ae?be(i.DEPTH_TEST):Ye(i.DEPTH_TEST)},setMask:function(Ae){se!==Ae&&!z&&(i.depthMask(Ae),se=Ae)},setFunc:function(Ae){if(ae&&(Ae=Fm[Ae]),Re!==Ae){switch(Ae){case sc:i.depthFunc(i.NEVER);break;case rc:i.depthFunc(i.ALWAYS);break;case ac:i.depthFunc(i.LESS);break;case Aa:i.depthFunc(i.LEQUAL);break;case oc:i.depthFunc(i.EQUAL);break;case lc:i.depthFunc(i.GEQUAL);break;case cc:i.depthFunc(i.GREATER);break;case hc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Re=Ae}},setLocked:function(Ae){z=Ae},setClear:function(Ae){we!==Ae&&(we=Ae,ae&&(Ae=1-Ae),i.clearDepth(Ae))},reset:function(){z=!1,se=null,Re=null,we=null,ae=!1}}}function s(){let z=!1,ae=null,se=null,Re=null,we=null,Ae=null,Ze=null,it=null,fe=null;return{setTest:function(He){z||(He?be(i.STENCIL_TEST):Ye(i.STENCIL_TEST))},setMask:function(He){ae!==He&&!z&&(i.stencilMask(He),ae=He)},setFunc:function(He,st,De){(se!==He||Re!==st||we!==De)&&(i.stencilFunc(He,st,De),se=He,Re=st,we=De)},setOp:function(He,st,De){(Ae!==He||Ze!==st||it!==De)&&(i.stencilOp(He,st,De),Ae=He,Ze=st,it=De)},setLocked:function(He){z=He},setClear:function(He){fe!==He&&(i.clearStencil(He),fe=He)},reset:function(){z=!1,ae=null,se=null,Re=null,we=null,Ae=null,Ze=null,it=null,fe=null}}}let r=new t,a=new n,o=new s,l={},c=new WeakMap,u={},d={},f={},p=new WeakMap,g=[],_=null,m=!1,v=null,x=null,S=null,y=null,T=null,M=null,b=null,A=new Qe(0,0,0),O=0,N=!1,P=null,k=null,B=null,L=null,H=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),$=!1,ce=0,K=i.getParameter(i.VERSION);K.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(K)[1]),$=ce>=1):K.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),$=ce>=2);let ee=null,ne={},ue=i.getParameter(i.SCISSOR_BOX),de=i.getParameter(i.VIEWPORT),Q=new tn().fromArray(ue),ge=new tn().fromArray(de);function ye(z,ae,se,Re){let we=new Uint8Array(4),Ae=i.createTexture();i.bindTexture(z,Ae),i.texParameteri(z,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(z,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ze=0;Ze<se;Ze++)z===i.TEXTURE_3D||z===i.TEXTURE_2D_ARRAY?i.texImage3D(ae,0,i.RGBA,1,1,Re,0,i.RGBA,i.UNSIGNED_BYTE,we):i.texImage2D(ae+Ze,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,we);return Ae}let Te={};Te[i.TEXTURE_2D]=ye(i.TEXTURE_2D,i.TEXTURE_2D,1),Te[i.TEXTURE_CUBE_MAP]=ye(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Te[i.TEXTURE_2D_ARRAY]=ye(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Te[i.TEXTURE_3D]=ye(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),be(i.DEPTH_TEST),a.setFunc(Aa),Wt(!1),Tt(ud),be(i.CULL_FACE),Ft(kr);function be(z){u[z]!==!0&&(i.enable(z),u[z]=!0)}function Ye(z){u[z]!==!1&&(i.disable(z),u[z]=!1)}function he(z,ae){return f[z]!==ae?(i.bindFramebuffer(z,ae),f[z]=ae,z===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=ae),z===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=ae),!0):!1}function Ie(z,ae){let se=g,Re=!1;if(z){se=p.get(ae),se===void 0&&(se=[],p.set(ae,se));let we=z.textures;if(se.length!==we.length||se[0]!==i.COLOR_ATTACHMENT0){for(let Ae=0,Ze=we.length;Ae<Ze;Ae++)se[Ae]=i.COLOR_ATTACHMENT0+Ae;se.length=we.length,Re=!0}}else se[0]!==i.BACK&&(se[0]=i.BACK,Re=!0);Re&&i.drawBuffers(se)}function rt(z){return _!==z?(i.useProgram(z),_=z,!0):!1}let dt={[Fr]:i.FUNC_ADD,[sm]:i.FUNC_SUBTRACT,[rm]:i.FUNC_REVERSE_SUBTRACT};dt[am]=i.MIN,dt[om]=i.MAX;let qe={[lm]:i.ZERO,[cm]:i.ONE,[hm]:i.SRC_COLOR,[md]:i.SRC_ALPHA,[gm]:i.SRC_ALPHA_SATURATE,[pm]:i.DST_COLOR,[dm]:i.DST_ALPHA,[um]:i.ONE_MINUS_SRC_COLOR,[gd]:i.ONE_MINUS_SRC_ALPHA,[mm]:i.ONE_MINUS_DST_COLOR,[fm]:i.ONE_MINUS_DST_ALPHA,[vm]:i.CONSTANT_COLOR,[_m]:i.ONE_MINUS_CONSTANT_COLOR,[ym]:i.CONSTANT_ALPHA,[xm]:i.ONE_MINUS_CONSTANT_ALPHA};function Ft(z,ae,se,Re,we,Ae,Ze,it,fe,He){if(z===kr){m===!0&&(Ye(i.BLEND),m=!1);return}if(m===!1&&(be(i.BLEND),m=!0),z!==im){if(z!==v||He!==N){if((x!==Fr||T!==Fr)&&(i.blendEquation(i.FUNC_ADD),x=Fr,T=Fr),He)switch(z){case Oa:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case dd:i.blendFunc(i.ONE,i.ONE);break;case fd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case pd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ot("WebGLState: Invalid blending: ",z);break}else switch(z){case Oa:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case dd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case fd:ot("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case pd:ot("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ot("WebGLState: Invalid blending: ",z);break}S=null,y=null,M=null,b=null,A.set(0,0,0),O=0,v=z,N=He}return}we=we||ae,Ae=Ae||se,Ze=Ze||Re,(ae!==x||we!==T)&&(i.blendEquationSeparate(dt[ae],dt[we]),x=ae,T=we),(se!==S||Re!==y||Ae!==M||Ze!==b)&&(i.blendFuncSeparate(qe[se],qe[Re],qe[Ae],qe[Ze]),S=se,y=Re,M=Ae,b=Ze),(it.equals(A)===!1||fe!==O)&&(i.blendColor(it.r,it.g,it.b,fe),A.copy(it),O=fe),v=z,N=!1}function Rt(z,ae){z.side===ai?Ye(i.CULL_FACE):be(i.CULL_FACE);let se=z.side===ti;ae&&(se=!se),Wt(se),z.blending===Oa&&z.transparent===!1?Ft(kr):Ft(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),a.setFunc(z.depthFunc),a.setTest(z.depthTest),a.setMask(z.depthWrite),r.setMask(z.colorWrite);let Re=z.stencilWrite;o.setTest(Re),Re&&(o.setMask(z.stencilWriteMask),o.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),o.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),ut(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?be(i.SAMPLE_ALPHA_TO_COVERAGE):Ye(i.SAMPLE_ALPHA_TO_COVERAGE)}function Wt(z){P!==z&&(z?i.frontFace(i.CW):i.frontFace(i.CCW),P=z)}function Tt(z){z!==em?(be(i.CULL_FACE),z!==k&&(z===ud?i.cullFace(i.BACK):z===tm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ye(i.CULL_FACE),k=z}function Dt(z){z!==B&&($&&i.lineWidth(z),B=z)}function ut(z,ae,se){z?(be(i.POLYGON_OFFSET_FILL),(L!==ae||H!==se)&&(L=ae,H=se,a.getReversed()&&(ae=-ae,se=-se),i.polygonOffset(ae,se))):Ye(i.POLYGON_OFFSET_FILL)}function nn(z){z?be(i.SCISSOR_TEST):Ye(i.SCISSOR_TEST)}function rn(z){z===void 0&&(z=i.TEXTURE0+Y-1),ee!==z&&(i.activeTexture(z),ee=z)}function pn(z,ae,se){se===void 0&&(ee===null?se=i.TEXTURE0+Y-1:se=ee);let Re=ne[se];Re===void 0&&(Re={type:void 0,texture:void 0},ne[se]=Re),(Re.type!==z||Re.texture!==ae)&&(ee!==se&&(i.activeTexture(se),ee=se),i.bindTexture(z,ae||Te[z]),Re.type=z,Re.texture=ae)}function V(){let z=ne[ee];z!==void 0&&z.type!==void 0&&(i.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Ne(){try{i.compressedTexImage2D(...arguments)}catch(z){ot("WebGLState:",z)}}function tt(){try{i.compressedTexImage3D(...arguments)}catch(z){ot("WebGLState:",z)}}function ht(){try{i.texSubImage2D(...arguments)}catch(z){ot("WebGLState:",z)}}function Ce(){try{i.texSubImage3D(...arguments)}catch(z){ot("WebGLState:",z)}}function Vt(){try{i.compressedTexSubImage2D(...arguments)}catch(z){ot("WebGLState:",z)}}function Xe(){try{i.compressedTexSubImage3D(...arguments)}catch(z){ot("WebGLState:",z)}}function je(){try{i.texStorage2D(...arguments)}catch(z){ot("WebGLState:",z)}}function I(){try{i.texStorage3D(...arguments)}catch(z){ot("WebGLState:",z)}}function E(){try{i.texImage2D(...arguments)}catch(z){ot("WebGLState:",z)}}function q(){try{i.texImage3D(...arguments)}catch(z){ot("WebGLState:",z)}}function pe(z){return d[z]!==void 0?d[z]:i.getParameter(z)}function oe(z,ae){d[z]!==ae&&(i.pixelStorei(z,ae),d[z]=ae)}function Se(z){Q.equals(z)===!1&&(i.scissor(z.x,z.y,z.z,z.w),Q.copy(z))}function Me(z){ge.equals(z)===!1&&(i.viewport(z.x,z.y,z.z,z.w),ge.copy(z))}function ie(z,ae){let se=c.get(ae);se===void 0&&(se=new WeakMap,c.set(ae,se));let Re=se.get(z);Re===void 0&&(Re=i.getUniformBlockIndex(ae,z.name),i.uniformBlockBinding(ae,Re,Re),se.set(z,Re))}function re(z,ae,se){let we=c.get(ae).get(z);l[we]!==se&&(i.bindBufferBase(i.UNIFORM_BUFFER,we,se),l[we]=se)}function _e(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},d={},ee=null,ne={},f={},l={},p=new WeakMap,g=[],_=null,m=!1,v=null,x=null,S=null,y=null,T=null,M=null,b=null,A=new Qe(0,0,0),O=0,N=!1,P=null,k=null,B=null,L=null,H=null,Q.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:be,disable:Ye,bindFramebuffer:he,drawBuffers:Ie,useProgram:rt,setBlending:Ft,setMaterial:Rt,setFlipSided:Wt,setCullFace:Tt,setLineWidth:Dt,setPolygonOffset:ut,setScissorTest:nn,activeTexture:rn,bindTexture:pn,unbindTexture:V,compressedTexImage2D:Ne,compressedTexImage3D:tt,texImage2D:E,texImage3D:q,pixelStorei:oe,getParameter:pe,updateUBOMapping:ie,uniformBlockBinding:re,texStorage2D:je,texStorage3D:I,texSubImage2D:ht,texSubImage3D:Ce,compressedTexSubImage2D:Vt,compressedTexSubImage3D:Xe,scissor:Se,viewport:Me,reset:_e}}function GS(i,e,t,n,s,r,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ge,u=new WeakMap,d=new Set,f,p=new WeakMap,g=new Set,_=new FinalizationRegistry(I=>g.delete(I)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function v(I,E){return m?new OffscreenCanvas(I,E):No("canvas")}function x(I,E,q){let pe=1,oe=je(I);if((oe.width>q||oe.height>q)&&(pe=q/Math.max(oe.width,oe.height)),pe<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let Se=Math.floor(pe*oe.width),Me=Math.floor(pe*oe.height);f===void 0&&(f=v(Se,Me));let ie=E?v(Se,Me):f;return ie.width=Se,ie.height=Me,ie.getContext("2d").drawImage(I,0,0,Se,Me),Je("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+Se+"x"+Me+")."),ie}else return"data"in I&&Je("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),I;return I}function S(I){return I.generateMipmaps}function y(I){i.generateMipmap(I)}function T(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function M(I,E,q,pe,oe,Se=!1){if(I!==null){if(i[I]!==void 0)return i[I];Je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let Me;pe&&(Me=e.get("EXT_texture_norm16"),Me||Je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ie=E;if(E===i.RED&&(q===i.FLOAT&&(ie=i.R32F),q===i.HALF_FLOAT&&(ie=i.R16F),q===i.UNSIGNED_BYTE&&(ie=i.R8),q===i.UNSIGNED_SHORT&&Me&&(ie=Me.R16_EXT),q===i.SHORT&&Me&&(ie=Me.R16_SNORM_EXT)),E===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(ie=i.R8UI),q===i.UNSIGNED_SHORT&&(ie=i.R16UI),q===i.UNSIGNED_INT&&(ie=i.R32UI),q===i.BYTE&&(ie=i.R8I),q===i.SHORT&&(ie=i.R16I),q===i.INT&&(ie=i.R32I)),E===i.RG&&(q===i.FLOAT&&(ie=i.RG32F),q===i.HALF_FLOAT&&(ie=i.RG16F),q===i.UNSIGNED_BYTE&&(ie=i.RG8),q===i.UNSIGNED_SHORT&&Me&&(ie=Me.RG16_EXT),q===i.SHORT&&Me&&(ie=Me.RG16_SNORM_EXT)),E===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(ie=i.RG8UI),q===i.UNSIGNED_SHORT&&(ie=i.RG16UI),q===i.UNSIGNED_INT&&(ie=i.RG32UI),q===i.BYTE&&(ie=i.RG8I),q===i.SHORT&&(ie=i.RG16I),q===i.INT&&(ie=i.RG32I)),E===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(ie=i.RGB8UI),q===i.UNSIGNED_SHORT&&(ie=i.RGB16UI),q===i.UNSIGNED_INT&&(ie=i.RGB32UI),q===i.BYTE&&(ie=i.RGB8I),q===i.SHORT&&(ie=i.RGB16I),q===i.INT&&(ie=i.RGB32I)),E===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(ie=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(ie=i.RGBA16UI),q===i.UNSIGNED_INT&&(ie=i.RGBA32UI),q===i.BYTE&&(ie=i.RGBA8I),q===i.SHORT&&(ie=i.RGBA16I),q===i.INT&&(ie=i.RGBA32I)),E===i.RGB&&(q===i.UNSIGNED_SHORT&&Me&&(ie=Me.RGB16_EXT),q===i.SHORT&&Me&&(ie=Me.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(ie=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(ie=i.R11F_G11F_B10F)),E===i.RGBA){let re=Se?Do:Mt.getTransfer(oe);q===i.FLOAT&&(ie=i.RGBA32F),q===i.HALF_FLOAT&&(ie=i.RGBA16F),q===i.UNSIGNED_BYTE&&(ie=re===Nt?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&Me&&(ie=Me.RGBA16_EXT),q===i.SHORT&&Me&&(ie=Me.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(ie=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(ie=i.RGB5_A1)}return(ie===i.R16F||ie===i.R32F||ie===i.RG16F||ie===i.RG32F||ie===i.RGBA16F||ie===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function b(I,E){let q;return I?E===null||E===qi||E===Or?q=i.DEPTH24_STENCIL8:E===Yi?q=i.DEPTH32F_STENCIL8:E===za&&(q=i.DEPTH24_STENCIL8,Je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===qi||E===Or?q=i.DEPTH_COMPONENT24:E===Yi?q=i.DEPTH_COMPONENT32F:E===za&&(q=i.DEPTH_COMPONENT16),q}function A(I,E){return S(I)===!0||I.isFramebufferTexture&&I.minFilter!==Dn&&I.minFilter!==Jn?Math.log2(Math.max(E.width,E.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?E.mipmaps.length:1}function O(I){let E=new WeakRef(I);n.get(I).__ref=E,g.add(E),_.register(I,E,E)}function N(I){let E=n.get(I).__ref;E!==void 0&&(g.delete(E),_.unregister(E))}function P(I){B(I.target)}function k(I){L(I.target)}function B(I){I.removeEventListener("dispose",P),N(I),Y(I),I.isVideoTexture&&u.delete(I),I.isHTMLTexture&&d.delete(I)}function L(I){I.removeEventListener("dispose",k),N(I),ce(I)}function H(){for(let I of g){let E=I.deref();E!==void 0&&(E.isRenderTarget===!0?L(E):B(E))}g.clear(),d.clear()}function Y(I){let E=n.get(I);if(E.__webglInit===void 0)return;let q=I.source,pe=p.get(q);if(pe){let oe=pe[E.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&$(I),Object.keys(pe).length===0&&p.delete(q)}n.remove(I)}function $(I){let E=n.get(I);i.deleteTexture(E.__webglTexture);let q=I.source,pe=p.get(q);delete pe[E.__cacheKey],a.memory.textures--}function ce(I){let E=n.get(I);E.__depthDisposeCallback&&E.__depthDisposeCallback();let q=I.depthTexture;if(q&&q.renderTarget===I&&B(q),I.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(E.__webglFramebuffer[oe]))for(let Se=0;Se<E.__webglFramebuffer[oe].length;Se++)i.deleteFramebuffer(E.__webglFramebuffer[oe][Se]);else i.deleteFramebuffer(E.__webglFramebuffer[oe]);E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer[oe])}else{if(Array.isArray(E.__webglFramebuffer))for(let oe=0;oe<E.__webglFramebuffer.length;oe++)i.deleteFramebuffer(E.__webglFramebuffer[oe]);else i.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&i.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let oe=0;oe<E.__webglColorRenderbuffer.length;oe++)E.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(E.__webglColorRenderbuffer[oe]);E.__webglDepthRenderbuffer&&i.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let pe=I.textures;for(let oe=0,Se=pe.length;oe<Se;oe++){let Me=n.get(pe[oe]);Me.__webglTexture&&(i.deleteTexture(Me.__webglTexture),a.memory.textures--),n.remove(pe[oe])}n.remove(I)}let K=0;function ee(){K=0}function ne(){return K}function ue(I){K=I}function de(){let I=K;return I>=s.maxTextures&&Je("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,I}function Q(I){let E=[];return E.push(I.wrapS),E.push(I.wrapT),E.push(I.wrapR||0),E.push(I.magFilter),E.push(I.minFilter),E.push(I.anisotropy),E.push(I.internalFormat),E.push(I.format),E.push(I.type),E.push(I.generateMipmaps),E.push(I.mipmapsAutoUpdate),E.push(I.premultiplyAlpha),E.push(I.flipY),E.push(I.unpackAlignment),E.push(I.colorSpace),E.join()}function ge(I,E){let q=n.get(I);if(I.isVideoTexture&&Vt(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&q.__version!==I.version){let pe=I.image;if(pe===null)Je("WebGLRenderer: Texture marked for update but no image data found.");else if(pe.complete===!1)Je("WebGLRenderer: Texture marked for update but image is incomplete");else{Rt(q,I,E);return}}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+E)}function ye(I,E){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Rt(q,I,E);return}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+E)}function Te(I,E){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Rt(q,I,E);return}t.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+E)}function be(I,E){let q=n.get(I);if(I.version>0&&q.__version!==I.version){Wt(q,I,E);return}t.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+E)}let Ye={[uc]:i.REPEAT,[hs]:i.CLAMP_TO_EDGE,[dc]:i.MIRRORED_REPEAT},he={[Dn]:i.NEAREST,[Sm]:i.NEAREST_MIPMAP_NEAREST,[il]:i.NEAREST_MIPMAP_LINEAR,[Jn]:i.LINEAR,[qc]:i.LINEAR_MIPMAP_NEAREST,[Fs]:i.LINEAR_MIPMAP_LINEAR},Ie={[Am]:i.NEVER,[Nd]:i.ALWAYS,[Cm]:i.LESS,[Id]:i.LEQUAL,[Rm]:i.EQUAL,[Dd]:i.GEQUAL,[Pm]:i.GREATER,[Lm]:i.NOTEQUAL};function rt(I,E){if(E.type===Yi&&e.has("OES_texture_float_linear")===!1&&(E.magFilter===Jn||E.magFilter===qc||E.magFilter===il||E.magFilter===Fs||E.minFilter===Jn||E.minFilter===qc||E.minFilter===il||E.minFilter===Fs)&&Je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,Ye[E.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,Ye[E.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,Ye[E.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,he[E.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,he[E.minFilter]),E.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,Ie[E.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Dn||E.minFilter!==il&&E.minFilter!==Fs||E.type===Yi&&e.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||n.get(E).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");i.texParameterf(I,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),n.get(E).__currentAnisotropy=E.anisotropy}}}function dt(I,E){let q=!1;I.__webglInit===void 0&&(I.__webglInit=!0,E.addEventListener("dispose",P),O(E));let pe=E.source,oe=p.get(pe);oe===void 0&&(oe={},p.set(pe,oe));let Se=Q(E);if(Se!==I.__cacheKey){oe[Se]===void 0&&(oe[Se]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,q=!0),oe[Se].usedTimes++;let Me=oe[I.__cacheKey];Me!==void 0&&(oe[I.__cacheKey].usedTimes--,Me.usedTimes===0&&$(E)),I.__cacheKey=Se,I.__webglTexture=oe[Se].texture}return q}function qe(I,E,q){return Math.floor(Math.floor(I/q)/E)}function Ft(I,E,q,pe){let Se=I.updateRanges;if(Se.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,E.width,E.height,q,pe,E.data);else{Se.sort((z,ae)=>z.start-ae.start);let Me=0;for(let z=1;z<Se.length;z++){let ae=Se[Me],se=Se[z],Re=ae.start+ae.count,we=qe(se.start,E.width,4),Ae=qe(ae.start,E.width,4);se.start<=Re+1&&we===Ae&&qe(se.start+se.count-1,E.width,4)===we?ae.count=Math.max(ae.count,se.start+se.count-ae.start):(++Me,Se[Me]=se)}Se.length=Me+1;let ie=t.getParameter(i.UNPACK_ROW_LENGTH),re=t.getParameter(i.UNPACK_SKIP_PIXELS),_e=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,E.width);for(let z=0,ae=Se.length;z<ae;z++){let se=Se[z],Re=Math.floor(se.start/4),we=Math.ceil(se.count/4),Ae=Re%E.width,Ze=Math.floor(Re/E.width),it=we,fe=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ae),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ze),t.texSubImage2D(i.TEXTURE_2D,0,Ae,Ze,it,fe,q,pe,E.data)}I.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ie),t.pixelStorei(i.UNPACK_SKIP_PIXELS,re),t.pixelStorei(i.UNPACK_SKIP_ROWS,_e)}}function Rt(I,E,q){let pe=i.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(pe=i.TEXTURE_2D_ARRAY),E.isData3DTexture&&(pe=i.TEXTURE_3D);let oe=dt(I,E),Se=E.source;t.bindTexture(pe,I.__webglTexture,i.TEXTURE0+q);let Me=n.get(Se);if(Se.version!==Me.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let fe=Mt.getPrimaries(Mt.workingColorSpace),He=E.colorSpace===Os?null:Mt.getPrimaries(E.colorSpace),st=E.colorSpace===Os||fe===He?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st)}t.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment);let re=x(E.image,!1,s.maxTextureSize);re=Xe(E,re);let _e=r.convert(E.format,E.colorSpace),z=r.convert(E.type),ae=M(E.internalFormat,_e,z,E.normalized,E.colorSpace,E.isVideoTexture);rt(pe,E);let se,Re=E.mipmaps,we=E.isVideoTexture!==!0,Ae=Me.__version===void 0||oe===!0,Ze=Se.dataReady,it=A(E,re);if(E.isDepthTexture)ae=b(E.format===Us,E.type),Ae&&(we?t.texStorage2D(i.TEXTURE_2D,1,ae,re.width,re.height):t.texImage2D(i.TEXTURE_2D,0,ae,re.width,re.height,0,_e,z,null));else if(E.isDataTexture)if(Re.length>0){we&&Ae&&t.texStorage2D(i.TEXTURE_2D,it,ae,Re[0].width,Re[0].height);for(let fe=0,He=Re.length;fe<He;fe++)se=Re[fe],we?Ze&&t.texSubImage2D(i.TEXTURE_2D,fe,0,0,se.width,se.height,_e,z,se.data):t.texImage2D(i.TEXTURE_2D,fe,ae,se.width,se.height,0,_e,z,se.data);E.generateMipmaps=!1}else we?(Ae&&t.texStorage2D(i.TEXTURE_2D,it,ae,re.width,re.height),Ze&&Ft(E,re,_e,z)):t.texImage2D(i.TEXTURE_2D,0,ae,re.width,re.height,0,_e,z,re.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){we&&Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,it,ae,Re[0].width,Re[0].height,re.depth);for(let fe=0,He=Re.length;fe<He;fe++)if(se=Re[fe],E.format!==Ki)if(_e!==null)if(we){if(Ze)if(E.layerUpdates.size>0){let st=$d(se.width,se.height,E.format,E.type);for(let De of E.layerUpdates){let ft=se.data.subarray(De*st/se.data.BYTES_PER_ELEMENT,(De+1)*st/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,fe,0,0,De,se.width,se.height,1,_e,ft)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,fe,0,0,0,se.width,se.height,re.depth,_e,se.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,fe,ae,se.width,se.height,re.depth,0,se.data,0,0);else Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else we?Ze&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,fe,0,0,0,se.width,se.height,re.depth,_e,z,se.data):t.texImage3D(i.TEXTURE_2D_ARRAY,fe,ae,se.width,se.height,re.depth,0,_e,z,se.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{we&&Ae&&t.texStorage2D(i.TEXTURE_2D,it,ae,Re[0].width,Re[0].height);for(let fe=0,He=Re.length;fe<He;fe++)se=Re[fe],E.format!==Ki?_e!==null?we?Ze&&t.compressedTexSubImage2D(i.TEXTURE_2D,fe,0,0,se.width,se.height,_e,se.data):t.compressedTexImage2D(i.TEXTURE_2D,fe,ae,se.width,se.height,0,se.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):we?Ze&&t.texSubImage2D(i.TEXTURE_2D,fe,0,0,se.width,se.height,_e,z,se.data):t.texImage2D(i.TEXTURE_2D,fe,ae,se.width,se.height,0,_e,z,se.data)}else if(E.isDataArrayTexture)if(we){if(Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,it,ae,re.width,re.height,re.depth),Ze)if(E.layerUpdates.size>0){let fe=$d(re.width,re.height,E.format,E.type);for(let He of E.layerUpdates){let st=re.data.subarray(He*fe/re.data.BYTES_PER_ELEMENT,(He+1)*fe/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,He,re.width,re.height,1,_e,z,st)}E.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,_e,z,re.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ae,re.width,re.height,re.depth,0,_e,z,re.data);else if(E.isData3DTexture)we?(Ae&&t.texStorage3D(i.TEXTURE_3D,it,ae,re.width,re.height,re.depth),Ze&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,_e,z,re.data)):t.texImage3D(i.TEXTURE_3D,0,ae,re.width,re.height,re.depth,0,_e,z,re.data);else if(E.isFramebufferTexture){if(Ae)if(we)t.texStorage2D(i.TEXTURE_2D,it,ae,re.width,re.height);else{let fe=re.width,He=re.height;for(let st=0;st<it;st++)t.texImage2D(i.TEXTURE_2D,st,ae,fe,He,0,_e,z,null),fe>>=1,He>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in i){let fe=i.canvas;if(fe.hasAttribute("layoutsubtree")||fe.setAttribute("layoutsubtree","true"),re.parentNode!==fe){fe.appendChild(re),d.add(E),fe.onpaint=He=>{let st=He.changedElements;for(let De of d)st.includes(De.image)&&(De.needsUpdate=!0)},fe.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,re);else{let st=i.RGBA,De=i.RGBA,ft=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,st,De,ft,re)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Re.length>0){if(we&&Ae){let fe=je(Re[0]);t.texStorage2D(i.TEXTURE_2D,it,ae,fe.width,fe.height)}for(let fe=0,He=Re.length;fe<He;fe++)se=Re[fe],we?Ze&&t.texSubImage2D(i.TEXTURE_2D,fe,0,0,_e,z,se):t.texImage2D(i.TEXTURE_2D,fe,ae,_e,z,se);E.generateMipmaps=!1}else if(we){if(Ae){let fe=je(re);t.texStorage2D(i.TEXTURE_2D,it,ae,fe.width,fe.height)}Ze&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,_e,z,re)}else t.texImage2D(i.TEXTURE_2D,0,ae,_e,z,re);S(E)&&E.mipmapsAutoUpdate===!0&&y(pe),Me.__version=Se.version,E.onUpdate&&E.onUpdate(E)}I.__version=E.version}function Wt(I,E,q){if(E.image.length!==6)return;let pe=dt(I,E),oe=E.source;t.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+q);let Se=n.get(oe);if(oe.version!==Se.__version||pe===!0){t.activeTexture(i.TEXTURE0+q);let Me=Mt.getPrimaries(Mt.workingColorSpace),ie=E.colorSpace===Os?null:Mt.getPrimaries(E.colorSpace),re=E.colorSpace===Os||Me===ie?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let _e=E.isCompressedTexture||E.image[0].isCompressedTexture,z=E.image[0]&&E.image[0].isDataTexture,ae=[];for(let De=0;De<6;De++)!_e&&!z?ae[De]=x(E.image[De],!0,s.maxCubemapSize):ae[De]=z?E.image[De].image:E.image[De],ae[De]=Xe(E,ae[De]);let se=ae[0],Re=r.convert(E.format,E.colorSpace),we=r.convert(E.type),Ae=M(E.internalFormat,Re,we,E.normalized,E.colorSpace),Ze=E.isVideoTexture!==!0,it=Se.__version===void 0||pe===!0,fe=oe.dataReady,He=A(E,se);rt(i.TEXTURE_CUBE_MAP,E);let st;if(E.isDepthTexture){if(Ae=b(E.format===Us,E.type),it)if(Ze)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ae,se.width,se.height);else for(let De=0;De<6;De++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,0,Ae,se.width,se.height,0,Re,we,null)}else if(_e){Ze&&it&&t.texStorage2D(i.TEXTURE_CUBE_MAP,He,Ae,se.width,se.height);for(let De=0;De<6;De++){st=ae[De].mipmaps;for(let ft=0;ft<st.length;ft++){let qt=st[ft];E.format!==Ki?Re!==null?Ze?fe&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,ft,0,0,qt.width,qt.height,Re,qt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,ft,Ae,qt.width,qt.height,0,qt.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ze?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,ft,0,0,qt.width,qt.height,Re,we,qt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,ft,Ae,qt.width,qt.height,0,Re,we,qt.data)}}}else{if(st=E.mipmaps,Ze&&it){st.length>0&&He++;let De=je(ae[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,He,Ae,De.width,De.height)}for(let De=0;De<6;De++)if(z){Ze?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,0,0,0,ae[De].width,ae[De].height,Re,we,ae[De].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,0,Ae,ae[De].width,ae[De].height,0,Re,we,ae[De].data);for(let ft=0;ft<st.length;ft++){let Xn=st[ft].image[De].image;Ze?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,ft+1,0,0,Xn.width,Xn.height,Re,we,Xn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,ft+1,Ae,Xn.width,Xn.height,0,Re,we,Xn.data)}}else{Ze?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,0,0,0,Re,we,ae[De]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,0,Ae,Re,we,ae[De]);for(let ft=0;ft<st.length;ft++){let qt=st[ft];Ze?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,ft+1,0,0,Re,we,qt.image[De]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+De,ft+1,Ae,Re,we,qt.image[De])}}}S(E)&&E.mipmapsAutoUpdate===!0&&y(i.TEXTURE_CUBE_MAP),Se.__version=oe.version,E.onUpdate&&E.onUpdate(E)}I.__version=E.version}function Tt(I,E,q,pe,oe,Se){let Me=r.convert(q.format,q.colorSpace),ie=r.convert(q.type),re=M(q.internalFormat,Me,ie,q.normalized,q.colorSpace),_e=n.get(E),z=n.get(q);if(z.__renderTarget=E,!_e.__hasExternalTextures){let ae=Math.max(1,E.width>>Se),se=Math.max(1,E.height>>Se);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,Se,re,ae,se,E.depth,0,Me,ie,null):t.texImage2D(oe,Se,re,ae,se,0,Me,ie,null)}t.bindFramebuffer(i.FRAMEBUFFER,I),Ce(E)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,oe,z.__webglTexture,0,ht(E)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,pe,oe,z.__webglTexture,Se),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Dt(I,E,q){if(i.bindRenderbuffer(i.RENDERBUFFER,I),E.depthBuffer){let pe=E.depthTexture,oe=pe&&pe.isDepthTexture?pe.type:null,Se=b(E.stencilBuffer,oe),Me=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ce(E)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ht(E),Se,E.width,E.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ht(E),Se,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,Se,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Me,i.RENDERBUFFER,I)}else{let pe=E.textures;for(let oe=0;oe<pe.length;oe++){let Se=pe[oe],Me=r.convert(Se.format,Se.colorSpace),ie=r.convert(Se.type),re=M(Se.internalFormat,Me,ie,Se.normalized,Se.colorSpace);Ce(E)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ht(E),re,E.width,E.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ht(E),re,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,re,E.width,E.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function ut(I,E,q){let pe=E.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,I),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(E.depthTexture);oe.__renderTarget=E;let Se=pe?E.depthTexture.image[0]:E.depthTexture.image;(!oe.__webglTexture||Se.width!==E.width||Se.height!==E.height)&&(Se.width=E.width,Se.height=E.height,E.depthTexture.needsUpdate=!0),pe?be(E.depthTexture,0):ge(E.depthTexture,0);let Me=oe.__webglTexture,ie=ht(E),re=pe?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,_e=E.depthTexture.format===Us?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(E.depthTexture.format===Ps)Ce(E)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_e,re,Me,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,_e,re,Me,0);else if(E.depthTexture.format===Us)Ce(E)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_e,re,Me,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,_e,re,Me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function nn(I){let E=n.get(I),q=I.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==I.depthTexture){let pe=I.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),pe){let oe=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,pe.removeEventListener("dispose",oe)};pe.addEventListener("dispose",oe),E.__depthDisposeCallback=oe}E.__boundDepthTexture=pe}if(I.depthTexture&&!E.__autoAllocateDepthBuffer)if(q)for(let pe=0;pe<6;pe++)ut(E.__webglFramebuffer[pe],I,pe);else I.texture.mipmaps.length>0?ut(E.__webglFramebuffer[0],I,0):ut(E.__webglFramebuffer,I,0);else if(q){E.__webglDepthbuffer=[];for(let pe=0;pe<6;pe++)if(t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[pe]),E.__webglDepthbuffer[pe]===void 0)E.__webglDepthbuffer[pe]=i.createRenderbuffer(),Dt(E.__webglDepthbuffer[pe],I,!1);else{let oe=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Se=E.__webglDepthbuffer[pe];i.bindRenderbuffer(i.RENDERBUFFER,Se),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,Se)}}else if(I.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=i.createRenderbuffer(),Dt(E.__webglDepthbuffer,I,!1);else{let oe=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Se=E.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,Se),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,Se)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function rn(I,E,q){let pe=n.get(I);E!==void 0&&Tt(pe.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&nn(I)}function pn(I){let E=I.texture,q=n.get(I),pe=n.get(E);I.addEventListener("dispose",k),O(I);let oe=I.textures,Se=I.isWebGLCubeRenderTarget===!0,Me=oe.length>1;if(Me||(pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture()),pe.__version=E.version,a.memory.textures++),Se){q.__webglFramebuffer=[];for(let ie=0;ie<6;ie++)if(E.mipmaps.length>0){q.__webglFramebuffer[ie]=[];for(let re=0;re<E.mipmaps.length;re++)q.__webglFramebuffer[ie][re]=i.createFramebuffer()}else q.__webglFramebuffer[ie]=i.createFramebuffer()}else{if(E.mipmaps.length>0){q.__webglFramebuffer=[];for(let ie=0;ie<E.mipmaps.length;ie++)q.__webglFramebuffer[ie]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(Me)for(let ie=0,re=oe.length;ie<re;ie++){let _e=n.get(oe[ie]);_e.__webglTexture===void 0&&(_e.__webglTexture=i.createTexture(),a.memory.textures++)}if(I.samples>0&&Ce(I)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let ie=0;ie<oe.length;ie++){let re=oe[ie];q.__webglColorRenderbuffer[ie]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[ie]);let _e=r.convert(re.format,re.colorSpace),z=r.convert(re.type),ae=M(re.internalFormat,_e,z,re.normalized,re.colorSpace,I.isXRRenderTarget===!0),se=ht(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,se,ae,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ie,i.RENDERBUFFER,q.__webglColorRenderbuffer[ie])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),Dt(q.__webglDepthRenderbuffer,I,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(Se){t.bindTexture(i.TEXTURE_CUBE_MAP,pe.__webglTexture),rt(i.TEXTURE_CUBE_MAP,E);for(let ie=0;ie<6;ie++)if(E.mipmaps.length>0)for(let re=0;re<E.mipmaps.length;re++)Tt(q.__webglFramebuffer[ie][re],I,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ie,re);else Tt(q.__webglFramebuffer[ie],I,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ie,0);S(E)?y(i.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}else if(Me){for(let ie=0,re=oe.length;ie<re;ie++){let _e=oe[ie],z=n.get(_e),ae=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ae=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ae,z.__webglTexture),rt(ae,_e),Tt(q.__webglFramebuffer,I,_e,i.COLOR_ATTACHMENT0+ie,ae,0),S(_e)&&y(ae)}t.unbindTexture()}else{let ie=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ie=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ie,pe.__webglTexture),rt(ie,E),E.mipmaps.length>0)for(let re=0;re<E.mipmaps.length;re++)Tt(q.__webglFramebuffer[re],I,E,i.COLOR_ATTACHMENT0,ie,re);else Tt(q.__webglFramebuffer,I,E,i.COLOR_ATTACHMENT0,ie,0);S(E)?y(ie):E.mipmaps.length>0&&i.texParameteri(ie,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}I.depthBuffer&&nn(I)}function V(I){let E=I.textures;for(let q=0,pe=E.length;q<pe;q++){let oe=E[q];if(S(oe)&&oe.mipmapsAutoUpdate===!0){let Se=T(I),Me=n.get(oe).__webglTexture;t.bindTexture(Se,Me),y(Se),t.unbindTexture()}}}let Ne=[];function tt(I){if(I.samples>0){if(Ce(I)===!1){let E=I.textures,q=I.width,pe=I.height,oe=i.COLOR_BUFFER_BIT,Se=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Me=n.get(I),ie=E.length>1;if(ie)for(let _e=0;_e<E.length;_e++)t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Me.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer);for(let _e=0;_e<E.length;_e++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),ie){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Me.__webglColorRenderbuffer[_e]);let z=n.get(E[_e]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,z,0)}i.blitFramebuffer(0,0,q,pe,0,0,q,pe,oe,i.NEAREST),l===!0&&(Ne.length=0,Ne.push(i.COLOR_ATTACHMENT0+_e),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Ne.push(Se),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ne))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ie)for(let _e=0;_e<E.length;_e++){t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.RENDERBUFFER,Me.__webglColorRenderbuffer[_e]);let z=n.get(E[_e]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.TEXTURE_2D,z,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let E=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[E])}}}function ht(I){return Math.min(s.maxSamples,I.samples)}function Ce(I){let E=n.get(I);return I.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function Vt(I){let E=a.render.frame;u.get(I)!==E&&(u.set(I,E),I.update())}function Xe(I,E){let q=I.colorSpace,pe=I.format,oe=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||q!==Io&&q!==Os&&(Mt.getTransfer(q)===Nt?(pe!==Ki||oe!==oi)&&Je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ot("WebGLTextures: Unsupported texture color space:",q)),E}function je(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=ee,this.getTextureUnits=ne,this.setTextureUnits=ue,this.setTexture2D=ge,this.setTexture2DArray=ye,this.setTexture3D=Te,this.setTextureCube=be,this.rebindTextures=rn,this.setupRenderTarget=pn,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=tt,this.setupDepthRenderbuffer=nn,this.setupFrameBufferTexture=Tt,this.useMultisampledRTT=Ce,this.dispose=H}function HS(i,e){function t(n,s=Os){let r,a=Mt.getTransfer(s);if(n===oi)return i.UNSIGNED_BYTE;if(n===Zc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Kc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Ad)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Cd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Ed)return i.BYTE;if(n===Td)return i.SHORT;if(n===za)return i.UNSIGNED_SHORT;if(n===Yc)return i.INT;if(n===qi)return i.UNSIGNED_INT;if(n===Yi)return i.FLOAT;if(n===Zi)return i.HALF_FLOAT;if(n===Rd)return i.ALPHA;if(n===Pd)return i.RGB;if(n===Ki)return i.RGBA;if(n===Ps)return i.DEPTH_COMPONENT;if(n===Us)return i.DEPTH_STENCIL;if(n===Ld)return i.RED;if(n===jc)return i.RED_INTEGER;if(n===ur)return i.RG;if(n===Jc)return i.RG_INTEGER;if(n===Qc)return i.RGBA_INTEGER;if(n===sl||n===rl||n===al||n===ol)if(a===Nt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===sl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===rl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===al)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===sl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===rl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===al)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ol)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===eh||n===th||n===nh||n===ih)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===eh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===th)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===nh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ih)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===sh||n===rh||n===ah||n===oh||n===lh||n===ll||n===ch)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===sh||n===rh)return a===Nt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===ah)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===oh)return r.COMPRESSED_R11_EAC;if(n===lh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===ll)return r.COMPRESSED_RG11_EAC;if(n===ch)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===hh||n===uh||n===dh||n===fh||n===ph||n===mh||n===gh||n===vh||n===_h||n===yh||n===xh||n===bh||n===wh||n===Sh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===hh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===uh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===dh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===fh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ph)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===mh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===gh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===vh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===_h)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===yh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===xh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===bh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===wh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Sh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Mh||n===Eh||n===Th)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Mh)return a===Nt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Eh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Th)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ah||n===Ch||n===cl||n===Rh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ah)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Ch)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===cl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Rh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Or?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var WS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,$S=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,ef=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ho(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ds({vertexShader:WS,fragmentShader:$S,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new hn(new Xo(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},tf=class extends Xi{constructor(e,t){super();let n=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,u=null,d=null,f=null,p=null,g=null,_=typeof XRWebGLBinding<"u",m=new ef,v={},x=t.getContextAttributes(),S=null,y=null,T=[],M=[],b=new Ge,A=null,O=null,N=new xi;N.viewport=new tn;let P=new xi;P.viewport=new tn;let k=[N,P],B=new Hc,L=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let ge=T[Q];return ge===void 0&&(ge=new Ia,T[Q]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(Q){let ge=T[Q];return ge===void 0&&(ge=new Ia,T[Q]=ge),ge.getGripSpace()},this.getHand=function(Q){let ge=T[Q];return ge===void 0&&(ge=new Ia,T[Q]=ge),ge.getHandSpace()};function Y(Q){let ge=M.indexOf(Q.inputSource);if(ge===-1)return;let ye=T[ge];ye!==void 0&&(ye.update(Q.inputSource,Q.frame,c||a),ye.dispatchEvent({type:Q.type,data:Q.inputSource}))}function $(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",$),s.removeEventListener("inputsourceschange",ce);for(let Q=0;Q<T.length;Q++){let ge=M[Q];ge!==null&&(M[Q]=null,T[Q].disconnect(ge))}L=null,H=null,m.reset();for(let Q in v)delete v[Q];if(e.setRenderTarget(S),p=null,f=null,d=null,s=null,y=null,de.stop(),n.isPresenting=!1,e.setPixelRatio(A),e.setSize(b.width,b.height,!1),O!==null){let Q=O.camera;Q.fov=O.fov,Q.zoom=O.zoom,Q.updateProjectionMatrix(),O=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&Je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){o=Q,n.isPresenting===!0&&Je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return d===null&&_&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(S=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",$),s.addEventListener("inputsourceschange",ce),x.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(b),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let ye=null,Te=null,be=null;x.depth&&(be=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ye=x.stencil?Us:Ps,Te=x.stencil?Or:qi);let Ye={colorFormat:t.RGBA8,depthFormat:be,scaleFactor:r};d=this.getBinding(),f=d.createProjectionLayer(Ye),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),y=new bi(f.textureWidth,f.textureHeight,{format:Ki,type:oi,depthTexture:new Ns(f.textureWidth,f.textureHeight,Te,void 0,void 0,void 0,void 0,void 0,void 0,ye),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ye={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,ye),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),y=new bi(p.framebufferWidth,p.framebufferHeight,{format:Ki,type:oi,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),de.setContext(s),de.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ce(Q){for(let ge=0;ge<Q.removed.length;ge++){let ye=Q.removed[ge],Te=M.indexOf(ye);Te>=0&&(M[Te]=null,T[Te].disconnect(ye))}for(let ge=0;ge<Q.added.length;ge++){let ye=Q.added[ge],Te=M.indexOf(ye);if(Te===-1){for(let Ye=0;Ye<T.length;Ye++)if(Ye>=M.length){M.push(ye),Te=Ye;break}else if(M[Ye]===null){M[Ye]=ye,Te=Ye;break}if(Te===-1)break}let be=T[Te];be&&be.connect(ye)}}function K(Q,ge){ge===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(ge.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let ge=Q.near,ye=Q.far;m.texture!==null&&(m.depthNear>0&&(ge=m.depthNear),m.depthFar>0&&(ye=m.depthFar)),B.near=P.near=N.near=ge,B.far=P.far=N.far=ye,(L!==B.near||H!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),L=B.near,H=B.far),B.layers.mask=Q.layers.mask|6,N.layers.mask=B.layers.mask&-5,P.layers.mask=B.layers.mask&-3;let Te=Q.parent,be=B.cameras;K(B,Te);for(let Ye=0;Ye<be.length;Ye++)K(be[Ye],Te);B.projectionMatrix.copy(N.projectionMatrix),B.projectionMatrixInverse.copy(N.projectionMatrixInverse),O===null&&Q.isPerspectiveCamera&&(O={camera:Q,fov:Q.fov,zoom:Q.zoom}),ee(Q,B,Te)};function ee(Q,ge,ye){ye===null?Q.matrix.copy(ge.matrixWorld):(Q.matrix.copy(ye.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(ge.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(ge.projectionMatrix),Q.projectionMatrixInverse.copy(ge.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Pa*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(Q){l=Q,f!==null&&(f.fixedFoveation=Q),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(B)},this.getCameraTexture=function(Q){return v[Q]};let ne=null;function ue(Q,ge){if(u=ge.getViewerPose(c||a),g=ge,u!==null){let ye=u.views;p!==null&&(e.setRenderTargetFramebuffer(y,p.framebuffer),e.setRenderTarget(y));let Te=!1;ye.length!==B.cameras.length&&(B.cameras.length=0,Te=!0);for(let Ie=0;Ie<ye.length;Ie++){let rt=ye[Ie],dt=null;if(p!==null)dt=p.getViewport(rt);else{let Ft=d.getViewSubImage(f,rt);dt=Ft.viewport,Ie===0&&(e.setRenderTargetTextures(y,Ft.colorTexture,Ft.depthStencilTexture),e.setRenderTarget(y))}let qe=k[Ie];qe===void 0&&(qe=new xi,qe.layers.enable(Ie),qe.viewport=new tn,k[Ie]=qe),qe.matrix.fromArray(rt.transform.matrix),qe.matrix.decompose(qe.position,qe.quaternion,qe.scale),qe.projectionMatrix.fromArray(rt.projectionMatrix),qe.projectionMatrixInverse.copy(qe.projectionMatrix).invert(),qe.viewport.set(dt.x,dt.y,dt.width,dt.height),Ie===0&&(B.matrix.copy(qe.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),Te===!0&&B.cameras.push(qe)}let be=s.enabledFeatures;if(be&&be.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){d=n.getBinding();let Ie=d.getDepthInformation(ye[0]);Ie&&Ie.isValid&&Ie.texture&&m.init(Ie,s.renderState)}if(be&&be.includes("camera-access")&&_){e.state.unbindTexture(),d=n.getBinding();for(let Ie=0;Ie<ye.length;Ie++){let rt=ye[Ie].camera;if(rt){let dt=v[rt];dt||(dt=new Ho,v[rt]=dt);let qe=d.getCameraImage(rt);dt.sourceTexture=qe}}}}for(let ye=0;ye<T.length;ye++){let Te=M[ye],be=T[ye];Te!==null&&be!==void 0&&be.update(Te,ge,c||a)}ne&&ne(Q,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),g=null}let de=new hg;de.setAnimationLoop(ue),this.setAnimationLoop=function(Q){ne=Q},this.dispose=function(){}}},XS=new $t,xg=new lt;xg.set(-1,0,0,0,1,0,0,0,1);function qS(i,e){function t(m,v){m.matrixAutoUpdate===!0&&m.updateMatrix(),v.value.copy(m.matrix)}function n(m,v){v.color.getRGB(m.fogColor.value,Gd(i)),v.isFog?(m.fogNear.value=v.near,m.fogFar.value=v.far):v.isFogExp2&&(m.fogDensity.value=v.density)}function s(m,v,x,S,y){v.isNodeMaterial?v.uniformsNeedUpdate=!1:v.isMeshBasicMaterial?r(m,v):v.isMeshLambertMaterial?(r(m,v),v.envMap&&(m.envMapIntensity.value=v.envMapIntensity)):v.isMeshToonMaterial?(r(m,v),d(m,v)):v.isMeshPhongMaterial?(r(m,v),u(m,v),v.envMap&&(m.envMapIntensity.value=v.envMapIntensity)):v.isMeshStandardMaterial?(r(m,v),f(m,v),v.isMeshPhysicalMaterial&&p(m,v,y)):v.isMeshMatcapMaterial?(r(m,v),g(m,v)):v.isMeshDepthMaterial?r(m,v):v.isMeshDistanceMaterial?(r(m,v),_(m,v)):v.isMeshNormalMaterial?r(m,v):v.isLineBasicMaterial?(a(m,v),v.isLineDashedMaterial&&o(m,v)):v.isPointsMaterial?l(m,v,x,S):v.isSpriteMaterial?c(m,v):v.isShadowMaterial?(m.color.value.copy(v.color),m.opacity.value=v.opacity):v.isShaderMaterial&&(v.uniformsNeedUpdate=!1)}function r(m,v){m.opacity.value=v.opacity,v.color&&m.diffuse.value.copy(v.color),v.emissive&&m.emissive.value.copy(v.emissive).multiplyScalar(v.emissiveIntensity),v.map&&(m.map.value=v.map,t(v.map,m.mapTransform)),v.alphaMap&&(m.alphaMap.value=v.alphaMap,t(v.alphaMap,m.alphaMapTransform)),v.bumpMap&&(m.bumpMap.value=v.bumpMap,t(v.bumpMap,m.bumpMapTransform),m.bumpScale.value=v.bumpScale,v.side===ti&&(m.bumpScale.value*=-1)),v.normalMap&&(m.normalMap.value=v.normalMap,t(v.normalMap,m.normalMapTransform),m.normalScale.value.copy(v.normalScale),v.side===ti&&m.normalScale.value.negate()),v.displacementMap&&(m.displacementMap.value=v.displacementMap,t(v.displacementMap,m.displacementMapTransform),m.displacementScale.value=v.displacementScale,m.displacementBias.value=v.displacementBias),v.emissiveMap&&(m.emissiveMap.value=v.emissiveMap,t(v.emissiveMap,m.emissiveMapTransform)),v.specularMap&&(m.specularMap.value=v.specularMap,t(v.specularMap,m.specularMapTransform)),v.alphaTest>0&&(m.alphaTest.value=v.alphaTest);let x=e.get(v),S=x.envMap,y=x.envMapRotation;S&&(m.envMap.value=S,m.envMapRotation.value.setFromMatrix4(XS.makeRotationFromEuler(y)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(xg),m.reflectivity.value=v.reflectivity,m.ior.value=v.ior,m.refractionRatio.value=v.refractionRatio),v.lightMap&&(m.lightMap.value=v.lightMap,m.lightMapIntensity.value=v.lightMapIntensity,t(v.lightMap,m.lightMapTransform)),v.aoMap&&(m.aoMap.value=v.aoMap,m.aoMapIntensity.value=v.aoMapIntensity,t(v.aoMap,m.aoMapTransform))}function a(m,v){m.diffuse.value.copy(v.color),m.opacity.value=v.opacity,v.map&&(m.map.value=v.map,t(v.map,m.mapTransform))}function o(m,v){m.dashSize.value=v.dashSize,m.totalSize.value=v.dashSize+v.gapSize,m.scale.value=v.scale}function l(m,v,x,S){m.diffuse.value.copy(v.color),m.opacity.value=v.opacity,m.size.value=v.size*x,m.scale.value=S*.5,v.map&&(m.map.value=v.map,t(v.map,m.uvTransform)),v.alphaMap&&(m.alphaMap.value=v.alphaMap,t(v.alphaMap,m.alphaMapTransform)),v.alphaTest>0&&(m.alphaTest.value=v.alphaTest)}function c(m,v){m.diffuse.value.copy(v.color),m.opacity.value=v.opacity,m.rotation.value=v.rotation,v.map&&(m.map.value=v.map,t(v.map,m.mapTransform)),v.alphaMap&&(m.alphaMap.value=v.alphaMap,t(v.alphaMap,m.alphaMapTransform)),v.alphaTest>0&&(m.alphaTest.value=v.alphaTest)}function u(m,v){m.specular.value.copy(v.specular),m.shininess.value=Math.max(v.shininess,1e-4)}function d(m,v){v.gradientMap&&(m.gradientMap.value=v.gradientMap)}function f(m,v){m.metalness.value=v.metalness,v.metalnessMap&&(m.metalnessMap.value=v.metalnessMap,t(v.metalnessMap,m.metalnessMapTransform)),m.roughness.value=v.roughness,v.roughnessMap&&(m.roughnessMap.value=v.roughnessMap,t(v.roughnessMap,m.roughnessMapTransform)),v.envMap&&(m.envMapIntensity.value=v.envMapIntensity)}function p(m,v,x){m.ior.value=v.ior,v.diffuseRoughness>0&&(m.diffuseRoughness.value=v.diffuseRoughness,v.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=v.diffuseRoughnessMap,t(v.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),v.sheen>0&&(m.sheenColor.value.copy(v.sheenColor).multiplyScalar(v.sheen),m.sheenRoughness.value=v.sheenRoughness,v.sheenColorMap&&(m.sheenColorMap.value=v.sheenColorMap,t(v.sheenColorMap,m.sheenColorMapTransform)),v.sheenRoughnessMap&&(m.sheenRoughnessMap.value=v.sheenRoughnessMap,t(v.sheenRoughnessMap,m.sheenRoughnessMapTransform))),v.clearcoat>0&&(m.clearcoat.value=v.clearcoat,m.clearcoatRoughness.value=v.clearcoatRoughness,v.clearcoatMap&&(m.clearcoatMap.value=v.clearcoatMap,t(v.clearcoatMap,m.clearcoatMapTransform)),v.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=v.clearcoatRoughnessMap,t(v.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),v.clearcoatNormalMap&&(m.clearcoatNormalMap.value=v.clearcoatNormalMap,t(v.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(v.clearcoatNormalScale),v.side===ti&&m.clearcoatNormalScale.value.negate())),v.dispersion>0&&(m.dispersion.value=v.dispersion),v.retroreflectivity>0&&(m.retroreflectivity.value=v.retroreflectivity),v.iridescence>0&&(m.iridescence.value=v.iridescence,m.iridescenceIOR.value=v.iridescenceIOR,m.iridescenceThicknessMinimum.value=v.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=v.iridescenceThicknessMaximum,v.iridescenceMap&&(m.iridescenceMap.value=v.iridescenceMap,t(v.iridescenceMap,m.iridescenceMapTransform)),v.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=v.iridescenceThicknessMap,t(v.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),v.transmission>0&&(m.transmission.value=v.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),v.transmissionMap&&(m.transmissionMap.value=v.transmissionMap,t(v.transmissionMap,m.transmissionMapTransform)),m.thickness.value=v.thickness,v.thicknessMap&&(m.thicknessMap.value=v.thicknessMap,t(v.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=v.attenuationDistance,m.attenuationColor.value.copy(v.attenuationColor)),v.anisotropy>0&&(m.anisotropyVector.value.set(v.anisotropy*Math.cos(v.anisotropyRotation),v.anisotropy*Math.sin(v.anisotropyRotation)),v.anisotropyMap&&(m.anisotropyMap.value=v.anisotropyMap,t(v.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=v.specularIntensity,m.specularColor.value.copy(v.specularColor),v.specularColorMap&&(m.specularColorMap.value=v.specularColorMap,t(v.specularColorMap,m.specularColorMapTransform)),v.specularIntensityMap&&(m.specularIntensityMap.value=v.specularIntensityMap,t(v.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,v){v.matcap&&(m.matcap.value=v.matcap)}function _(m,v){let x=e.get(v).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function YS(i,e,t,n){let s={},r={};function a(x,S){let y=S.program;n.uniformBlockBinding(x,y,s[x.id])}function o(x,S){let y=s[x.id];y===void 0&&(g(x),y=l(x),s[x.id]=y,x.addEventListener("dispose",m));let T=S.program;n.updateUBOMapping(x,T);let M=e.render.frame;r[x.id]!==M&&(c(x),r[x.id]=M)}function l(x){let S=i.createBuffer(),y=x.__size,T=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,S),i.bufferData(i.UNIFORM_BUFFER,y,T),i.bindBuffer(i.UNIFORM_BUFFER,null),S}function c(x){let S=s[x.id],y=x.uniforms,T=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let M=0,b=y.length;M<b;M++){let A=y[M];if(Array.isArray(A))for(let O=0,N=A.length;O<N;O++)u(A[O],M,O,T);else u(A,M,0,T)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(x,S,y,T){if(f(x,S,y,T)===!0){let M=x.__offset,b=x.value;if(Array.isArray(b)){let A=0;for(let O=0;O<b.length;O++){let N=b[O],P=_(N,!0);d(N,x.__data,A),A+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else d(b,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,M,x.__data)}}function d(x,S,y){typeof x=="number"||typeof x=="boolean"?S[y]=x:x.isMatrix3?(S[y]=x.elements[0],S[y+1]=x.elements[1],S[y+2]=x.elements[2],S[y+3]=0,S[y+4]=x.elements[3],S[y+5]=x.elements[4],S[y+6]=x.elements[5],S[y+7]=0,S[y+8]=x.elements[6],S[y+9]=x.elements[7],S[y+10]=x.elements[8],S[y+11]=0):ArrayBuffer.isView(x)?S.set(x.subarray(0,S.length-y),y):x.toArray(S,y)}function f(x,S,y,T){let M=x.value,b=S+"_"+y;if(Array.isArray(M)){T[b]===void 0&&(T[b]=[]);let A=T[b],O=!1;for(let N=0;N<M.length;N++)p(M[N],A,N)===!0&&(O=!0);return O}return p(M,T,b)}function p(x,S,y){if(S[y]===void 0)return typeof x=="number"||typeof x=="boolean"?S[y]=x:ArrayBuffer.isView(x)?S[y]=x.slice():S[y]=x.clone(),!0;{let T=S[y];if(typeof x=="number"||typeof x=="boolean"){if(T!==x)return S[y]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(T.equals(x)===!1)return T.copy(x),!0}}return!1}function g(x){let S=x.uniforms,y=0,T=16;for(let b=0,A=S.length;b<A;b++){let O=Array.isArray(S[b])?S[b]:[S[b]];for(let N=0,P=O.length;N<P;N++){let k=O[N],B=Array.isArray(k.value)?k.value:[k.value],L=Array.isArray(S[b])||Array.isArray(k.value),H=y;for(let $=0,ce=B.length;$<ce;$++){let K=B[$],ee=_(K,L),ne=y%T,ue=ne%ee.boundary,de=ne+ue;y+=ue,de!==0&&T-de<ee.storage&&(y+=T-de),$===0&&(H=y),y+=ee.storage}let Y=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new Y((y-H)/Float32Array.BYTES_PER_ELEMENT),k.__offset=H}}let M=y%T;return M>0&&(y+=T-M),x.__size=y,x.__cache={},this}function _(x,S){let y={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(y.boundary=4,y.storage=4):x.isVector2?(y.boundary=8,y.storage=8):x.isVector3||x.isColor?(y.boundary=16,y.storage=12):x.isVector4?(y.boundary=16,y.storage=16):x.isMatrix3?(y.boundary=16,y.storage=48):x.isMatrix4?(y.boundary=16,y.storage=64):x.isTexture?Je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(y.boundary=16,y.storage=x.byteLength):Je("WebGLRenderer: Unsupported uniform value type.",x),S===!0&&(y.boundary=16,y.storage=Math.ceil(y.storage/16)*16),y}function m(x){let S=x.target;S.removeEventListener("dispose",m),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function v(){for(let x in s)i.deleteBuffer(s[x]);s={},r={}}return{bind:a,update:o,dispose:v}}var ZS=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ps=null;function KS(){return ps===null&&(ps=new _c(ZS,16,16,ur,Zi),ps.name="DFG_LUT",ps.minFilter=Jn,ps.magFilter=Jn,ps.wrapS=hs,ps.wrapT=hs,ps.generateMipmaps=!1,ps.needsUpdate=!0),ps}var Nh=class{constructor(e={}){let{canvas:t=Dm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:f=!1,outputBufferType:p=oi}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let _=p,m=new Set([Qc,Jc,jc]),v=new Set([oi,qi,za,Or,Zc,Kc]),x=new Uint32Array(4),S=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},T=null,M=null,b=[],A=[],O=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=fs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,P=!1,k=null,B=null,L=null,H=null;this._outputColorSpace=_i;let Y=0,$=0,ce=null,K=-1,ee=null,ne=new tn,ue=new tn,de=null,Q=new Qe(0),ge=0,ye=t.width,Te=t.height,be=1,Ye=null,he=null,Ie=new tn(0,0,ye,Te),rt=new tn(0,0,ye,Te),dt=!1,qe=new sr,Ft=new yc,Rt=!1,Wt=!1,Tt=new $t,Dt=new G,ut=new tn,nn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},rn=!1;function pn(){return ce===null?be:1}let V=n;function Ne(R,W){return t.getContext(R,W)}let tt,ht,Ce,Vt,Xe,je,I,E,q,pe,oe,Se,Me,ie,re,_e,z,ae,se,Re,we,Ae,Ze;try{let R={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",He,!1),t.addEventListener("webglcontextrestored",st,!1),t.addEventListener("webglcontextcreationerror",De,!1),V===null){let W="webgl2";if(V=Ne(W,R),V===null)throw Ne(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}it()}catch(R){throw t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",st,!1),t.removeEventListener("webglcontextcreationerror",De,!1),ot("WebGLRenderer: "+R.message),R}function it(){tt=new ow(V),tt.init(),we=new HS(V,tt),ht=new Kb(V,tt,e,we),Ce=new VS(V,tt),ht.reversedDepthBuffer&&f&&Ce.buffers.depth.setReversed(!0),B=V.createFramebuffer(),L=V.createFramebuffer(),H=V.createFramebuffer(),Vt=new hw(V),Xe=new AS,je=new GS(V,tt,Ce,Xe,ht,we,Vt),I=new aw(N),E=new dy(V),Ae=new Yb(V,E),q=new lw(V,E,Vt,Ae),pe=new dw(V,q,E,Ae,Vt),ae=new uw(V,ht,je),re=new jb(Xe),oe=new TS(N,I,tt,ht,Ae,re),Se=new qS(N,Xe),Me=new RS,ie=new kS(tt),z=new qb(N,I,Ce,pe,g,l),_e=new zS(N,pe,ht),Ze=new YS(V,Vt,ht,Ce),se=new Zb(V,tt,Vt),Re=new cw(V,tt,Vt),Vt.programs=oe.programs,N.capabilities=ht,N.extensions=tt,N.properties=Xe,N.renderLists=Me,N.shadowMap=_e,N.state=Ce,N.info=Vt}_!==oi&&(O=new pw(_,t.width,t.height,o,s,r));let fe=new tf(N,V);this.xr=fe,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let R=tt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=tt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return be},this.setPixelRatio=function(R){R!==void 0&&(be=R,this.setSize(ye,Te,!1))},this.getSize=function(R){return R.set(ye,Te)},this.setSize=function(R,W,te=!0){if(fe.isPresenting){Je("WebGLRenderer: Can't change size while VR device is presenting.");return}ye=R,Te=W,t.width=Math.floor(R*be),t.height=Math.floor(W*be),te===!0&&(t.style.width=R+"px",t.style.height=W+"px"),O!==null&&O.setSize(t.width,t.height),this.setViewport(0,0,R,W)},this.getDrawingBufferSize=function(R){return R.set(ye*be,Te*be).floor()},this.setDrawingBufferSize=function(R,W,te){ye=R,Te=W,be=te,t.width=Math.floor(R*te),t.height=Math.floor(W*te),this.setViewport(0,0,R,W)},this.setEffects=function(R){if(_===oi){ot("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let W=0;W<R.length;W++)if(R[W].isOutputPass===!0){Je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(ne)},this.getViewport=function(R){return R.copy(Ie)},this.setViewport=function(R,W,te,Z){R.isVector4?Ie.set(R.x,R.y,R.z,R.w):Ie.set(R,W,te,Z),Ce.viewport(ne.copy(Ie).multiplyScalar(pn()).round())},this.getScissor=function(R){return R.copy(rt)},this.setScissor=function(R,W,te,Z){R.isVector4?rt.set(R.x,R.y,R.z,R.w):rt.set(R,W,te,Z),Ce.scissor(ue.copy(rt).multiplyScalar(pn()).round())},this.getScissorTest=function(){return dt},this.setScissorTest=function(R){Ce.setScissorTest(dt=R)},this.setOpaqueSort=function(R){Ye=R},this.setTransparentSort=function(R){he=R},this.getClearColor=function(R){return R.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(R=!0,W=!0,te=!0){let Z=0;if(R){let j=!1;if(ce!==null){let Pe=ce.texture.format;j=m.has(Pe)}if(j){let Pe=ce.texture.type,ke=v.has(Pe),Le=z.getClearColor(),Fe=z.getClearAlpha(),$e=Le.r,at=Le.g,_t=Le.b;ke?(x[0]=$e,x[1]=at,x[2]=_t,x[3]=Fe,V.clearBufferuiv(V.COLOR,0,x)):(S[0]=$e,S[1]=at,S[2]=_t,S[3]=Fe,V.clearBufferiv(V.COLOR,0,S))}else Z|=V.COLOR_BUFFER_BIT}W&&(Z|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),te&&(Z|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&V.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),k=R},this.dispose=function(){t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",st,!1),t.removeEventListener("webglcontextcreationerror",De,!1),z.dispose(),Me.dispose(),ie.dispose(),je.dispose(),Xe.dispose(),I.dispose(),pe.dispose(),q.dispose(),Ae.dispose(),Ze.dispose(),oe.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",Pl),fe.removeEventListener("sessionend",ts),ys.stop()};function He(R){R.preventDefault(),Fd("WebGLRenderer: Context Lost."),P=!0}function st(){Fd("WebGLRenderer: Context Restored."),P=!1;let R=Vt.autoReset,W=_e.enabled,te=_e.autoUpdate,Z=_e.needsUpdate,j=_e.type;it(),Vt.autoReset=R,_e.enabled=W,_e.autoUpdate=te,_e.needsUpdate=Z,_e.type=j}function De(R){ot("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function ft(R){let W=R.target;W.removeEventListener("dispose",ft),qt(W)}function qt(R){Xn(R),Xe.remove(R)}function Xn(R){let W=Xe.get(R).programs;W!==void 0&&(W.forEach(function(te){oe.releaseProgram(te)}),R.isShaderMaterial&&oe.releaseShaderCache(R))}this.renderBufferDirect=function(R,W,te,Z,j,Pe){W===null&&(W=nn);let ke=j.isMesh&&j.matrixWorld.determinantAffine()<0,Le=ho(R,W,te,Z,j);Ce.setMaterial(Z,ke);let Fe=te.index,$e=1;if(Z.wireframe===!0){if(Fe=q.getWireframeAttribute(te),Fe===void 0)return;$e=2}let at=te.drawRange,_t=te.attributes.position,We=at.start*$e,yt=(at.start+at.count)*$e;Pe!==null&&(We=Math.max(We,Pe.start*$e),yt=Math.min(yt,(Pe.start+Pe.count)*$e)),Fe!==null?(We=Math.max(We,0),yt=Math.min(yt,Fe.count)):_t!=null&&(We=Math.max(We,0),yt=Math.min(yt,_t.count));let sn=yt-We;if(sn<0||sn===1/0)return;Ae.setup(j,Z,Le,te,Fe);let Ut,Ot=se;if(Fe!==null&&(Ut=E.get(Fe),Ot=Re,Ot.setIndex(Ut)),j.isMesh)Z.wireframe===!0?(Ce.setLineWidth(Z.wireframeLinewidth*pn()),Ot.setMode(V.LINES)):Ot.setMode(V.TRIANGLES);else if(j.isLine){let bn=Z.linewidth;bn===void 0&&(bn=1),Ce.setLineWidth(bn*pn()),j.isLineSegments?Ot.setMode(V.LINES):j.isLineLoop?Ot.setMode(V.LINE_LOOP):Ot.setMode(V.LINE_STRIP)}else j.isPoints?Ot.setMode(V.POINTS):j.isSprite&&Ot.setMode(V.TRIANGLES);if(j.isBatchedMesh)if(tt.get("WEBGL_multi_draw"))Ot.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let bn=j._multiDrawStarts,ze=j._multiDrawCounts,mn=j._multiDrawCount,wt=Fe?E.get(Fe).bytesPerElement:1,bs=Xe.get(Z).currentProgram.getUniforms();for(let gn=0;gn<mn;gn++)bs.setValue(V,"_gl_DrawID",gn),Ot.render(bn[gn]/wt,ze[gn])}else if(j.isInstancedMesh)Ot.renderInstances(We,sn,j.count);else if(te.isInstancedBufferGeometry){let bn=te._maxInstanceCount!==void 0?te._maxInstanceCount:1/0,ze=Math.min(te.instanceCount,bn);Ot.renderInstances(We,sn,ze)}else Ot.render(We,sn)};function oo(R,W,te,Z){k!==null&&R.isNodeMaterial&&k.setObject(Z,R),Rt===!0&&re.setState(R,te,!1),R.transparent===!0&&R.side===ai&&R.forceSinglePass===!1?(R.side=ti,R.needsUpdate=!0,ns(R,W,Z),R.side=hr,R.needsUpdate=!0,ns(R,W,Z),R.side=ai):ns(R,W,Z)}this.compile=function(R,W,te=null){te===null&&(te=R),k!==null&&k.renderStart(R,W,te),M=ie.get(te),M.init(W),A.push(M),te.traverseVisible(function(j){j.isLight&&j.layers.test(W.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),R!==te&&R.traverseVisible(function(j){j.isLight&&j.layers.test(W.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),M.setupLights(),k!==null&&k.updateLights(M.state.lightsArray),Wt=this.localClippingEnabled,Rt=re.init(this.clippingPlanes,Wt),Rt===!0&&re.setGlobalState(this.clippingPlanes,W),k!==null&&_e.render(M.state.shadowsArray,te,W);let Z=new Set;return R.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Pe=j.material;if(Pe)if(Array.isArray(Pe))for(let ke=0;ke<Pe.length;ke++){let Le=Pe[ke];oo(Le,te,W,j),Z.add(Le)}else oo(Pe,te,W,j),Z.add(Pe)}),M=A.pop(),k!==null&&k.renderEnd(),Z},this.compileAsync=function(R,W,te=null){let Z=this.compile(R,W,te);return new Promise(j=>{function Pe(){if(Z.forEach(function(ke){let Fe=Xe.get(ke).currentProgram;(Fe===void 0||Fe.isReady())&&Z.delete(ke)}),Z.size===0){j(R);return}setTimeout(Pe,10)}tt.get("KHR_parallel_shader_compile")!==null?Pe():setTimeout(Pe,10)})};let Jr=null;function vu(R){Jr&&Jr(R)}function Pl(){ys.stop()}function ts(){ys.start()}let ys=new hg;ys.setAnimationLoop(vu),typeof self<"u"&&ys.setContext(self),this.setAnimationLoop=function(R){Jr=R,fe.setAnimationLoop(R),R===null?ys.stop():ys.start()},fe.addEventListener("sessionstart",Pl),fe.addEventListener("sessionend",ts),this.render=function(R,W){if(W!==void 0&&W.isCamera!==!0){ot("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;k!==null&&k.renderStart(R,W);let te=fe.enabled===!0&&fe.isPresenting===!0,Z=O!==null&&(ce===null||te)&&O.begin(N,ce);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(W),W=fe.getCamera()),R.isScene===!0&&R.onBeforeRender(N,R,W,ce),M=ie.get(R,A.length),M.init(W),M.state.textureUnits=je.getTextureUnits(),A.push(M),Tt.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?Ft.setFromArrayCamera(W):qe.setFromProjectionMatrix(Tt,Di,W.reversedDepth),Wt=this.localClippingEnabled,Rt=re.init(this.clippingPlanes,Wt),T=Me.get(R,b.length),T.init(),b.push(T),this.info.render.frame++,fe.enabled===!0&&fe.isPresenting===!0){let ke=N.xr.getDepthSensingMesh();ke!==null&&xs(ke,W,-1/0,N.sortObjects)}xs(R,W,0,N.sortObjects),T.finish(),k!==null&&k.updateLights(M.state.lightsArray),N.sortObjects===!0&&T.sort(Ye,he),rn=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,rn&&z.addToRenderList(T,R),this.info.autoReset===!0&&this.info.reset(),Rt===!0&&re.beginShadows();let j=M.state.shadowsArray;if(_e.render(j,R,W),Rt===!0&&re.endShadows(),(Z&&O.hasRenderPass())===!1){let ke=T.opaque,Le=T.transmissive;if(M.setupLights(),W.isArrayCamera){let Fe=W.cameras;if(Le.length>0)for(let $e=0,at=Fe.length;$e<at;$e++){let _t=Fe[$e];Oi(ke,Le,R,_t)}rn&&z.render(R);for(let $e=0,at=Fe.length;$e<at;$e++){let _t=Fe[$e];lo(T,R,_t,_t.viewport)}}else Le.length>0&&Oi(ke,Le,R,W),rn&&z.render(R),lo(T,R,W)}ce!==null&&$===0&&(je.updateMultisampleRenderTarget(ce),je.updateRenderTargetMipmap(ce)),Z&&O.end(N),R.isScene===!0&&R.onAfterRender(N,R,W),Ae.resetDefaultState(),K=-1,ee=null,A.pop(),A.length>0?(M=A[A.length-1],je.setTextureUnits(M.state.textureUnits),Rt===!0&&re.setGlobalState(N.clippingPlanes,M.state.camera)):M=null,b.pop(),b.length>0?T=b[b.length-1]:T=null,k!==null&&k.renderEnd()};function xs(R,W,te,Z){if(R.visible===!1)return;if(R.layers.test(W.layers)){if(R.isGroup)te=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(W);else if(R.isLight)M.pushLight(R),R.castShadow&&M.pushShadow(R);else if(R.isSprite){let ke=W.isArrayCamera?Ft:qe;if(!R.frustumCulled||R.intersectsFrustum(ke)){Z&&ut.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Tt);let Le=pe.update(R),Fe=R.material;Fe.visible&&T.push(R,Le,Fe,te,ut.z,null,W)}}else if(R.isMesh||R.isLine||R.isPoints){let ke=W.isArrayCamera?Ft:qe;if(!R.frustumCulled||R.intersectsFrustum(ke)){let Le=pe.update(R),Fe=R.material;if(Z&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),ut.copy(R.boundingSphere.center)):(Le.boundingSphere===null&&Le.computeBoundingSphere(),ut.copy(Le.boundingSphere.center)),ut.applyMatrix4(R.matrixWorld).applyMatrix4(Tt)),Array.isArray(Fe)){let $e=Le.groups;for(let at=0,_t=$e.length;at<_t;at++){let We=$e[at],yt=Fe[We.materialIndex];yt&&yt.visible&&T.push(R,Le,yt,te,ut.z,We,W)}}else Fe.visible&&T.push(R,Le,Fe,te,ut.z,null,W)}}}let Pe=R.children;for(let ke=0,Le=Pe.length;ke<Le;ke++)xs(Pe[ke],W,te,Z)}function lo(R,W,te,Z){let{opaque:j,transmissive:Pe,transparent:ke}=R;M.setupLightsView(te),Rt===!0&&re.setGlobalState(N.clippingPlanes,te),Z&&Ce.viewport(ne.copy(Z)),j.length>0&&an(j,W,te),Pe.length>0&&an(Pe,W,te),ke.length>0&&an(ke,W,te),Ce.buffers.depth.setTest(!0),Ce.buffers.depth.setMask(!0),Ce.buffers.color.setMask(!0),Ce.setPolygonOffset(!1)}function Oi(R,W,te,Z){if((te.isScene===!0?te.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[Z.id]===void 0){let We=tt.has("EXT_color_buffer_half_float")||tt.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[Z.id]=new bi(1,1,{generateMipmaps:!0,type:We?Zi:oi,minFilter:Fs,samples:Math.max(4,ht.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Mt.workingColorSpace})}let Pe=M.state.transmissionRenderTarget[Z.id],ke=Z.viewport||ne;Pe.setSize(ke.z*N.transmissionResolutionScale,ke.w*N.transmissionResolutionScale);let Le=N.getRenderTarget(),Fe=N.getActiveCubeFace(),$e=N.getActiveMipmapLevel();N.setRenderTarget(Pe),N.getClearColor(Q),ge=N.getClearAlpha(),ge<1&&N.setClearColor(16777215,.5),N.clear(),rn&&z.render(te);let at=N.toneMapping;N.toneMapping=fs;let _t=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),M.setupLightsView(Z),Rt===!0&&re.setGlobalState(N.clippingPlanes,Z),an(R,te,Z),je.updateMultisampleRenderTarget(Pe),je.updateRenderTargetMipmap(Pe),tt.has("WEBGL_multisampled_render_to_texture")===!1){let We=!1;for(let yt=0,sn=W.length;yt<sn;yt++){let Ut=W[yt],{object:Ot,geometry:bn,material:ze,group:mn}=Ut;if(ze.side===ai&&Ot.layers.test(Z.layers)){let wt=ze.side;ze.side=ti,ze.needsUpdate=!0,un(Ot,te,Z,bn,ze,mn),ze.side=wt,ze.needsUpdate=!0,We=!0}}We===!0&&(je.updateMultisampleRenderTarget(Pe),je.updateRenderTargetMipmap(Pe))}N.setRenderTarget(Le,Fe,$e),N.setClearColor(Q,ge),_t!==void 0&&(Z.viewport=_t),N.toneMapping=at}function an(R,W,te){let Z=W.isScene===!0?W.overrideMaterial:null;for(let j=0,Pe=R.length;j<Pe;j++){let ke=R[j],{object:Le,geometry:Fe,group:$e}=ke,at=ke.material;at.allowOverride===!0&&Z!==null&&(at=Z),Le.layers.test(te.layers)&&un(Le,W,te,Fe,at,$e)}}function un(R,W,te,Z,j,Pe){k!==null&&j.isNodeMaterial&&k.setObject(R,j),R.onBeforeRender(N,W,te,Z,j,Pe),R.modelViewMatrix.multiplyMatrices(te.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),j.onBeforeRender(N,W,te,Z,R,Pe),j.transparent===!0&&j.side===ai&&j.forceSinglePass===!1?(j.side=ti,j.needsUpdate=!0,N.renderBufferDirect(te,W,Z,j,R,Pe),j.side=hr,j.needsUpdate=!0,N.renderBufferDirect(te,W,Z,j,R,Pe),j.side=ai):N.renderBufferDirect(te,W,Z,j,R,Pe),R.onAfterRender(N,W,te,Z,j,Pe)}function dn(R){let W=0;for(let te of R)te.texture!==null&&W++;return W}function ns(R,W,te){W.isScene!==!0&&(W=nn);let Z=Xe.get(R),j=M.state.lights,Pe=M.state.shadowsArray,ke=j.state.version,Le=oe.getParameters(R,j.state,Pe,W,te,M.state.lightProbeGridArray),Fe=oe.getProgramCacheKey(Le),$e=Z.programs;Z.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?W.environment:null,Z.fog=W.fog;let at=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;Z.envMap=I.get(R.envMap||Z.environment,at),Z.envMapRotation=Z.environment!==null&&R.envMap===null?W.environmentRotation:R.envMapRotation,$e===void 0&&(R.addEventListener("dispose",ft),$e=new Map,Z.programs=$e,Z.programVariants=new Map);let _t=$e.get(Fe);if(_t!==void 0){if(Z.currentProgram===_t&&Z.lightsStateVersion===ke)return co(R,Le),_t}else Le.uniforms=oe.getUniforms(R),k!==null&&R.isNodeMaterial&&k.build(R,te,Le),R.onBeforeCompile(Le,N),_t=oe.acquireProgram(Le,Fe),$e.set(Fe,_t),Z.uniforms=Le.uniforms;let We=Z.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(We.clippingPlanes=re.uniform),co(R,Le),Z.needsLights=Xs(R),Z.lightsStateVersion=ke,Z.needsLights&&(We.ambientLightColor.value=j.state.ambient,We.lightProbe.value=j.state.probe,We.sunLights.value=j.state.sun,We.sunLightShadows.value=j.state.sunShadow,We.directionalLights.value=j.state.directional,We.directionalLightShadows.value=j.state.directionalShadow,We.spotLights.value=j.state.spot,We.spotLightShadows.value=j.state.spotShadow,We.rectAreaLights.value=j.state.rectArea,We.ltc_1.value=j.state.rectAreaLTC1,We.ltc_2.value=j.state.rectAreaLTC2,We.pointLights.value=j.state.point,We.pointLightShadows.value=j.state.pointShadow,We.hemisphereLights.value=j.state.hemi,We.sunShadowMatrix.value=j.state.sunShadowMatrix,We.sunShadowCascade.value=j.state.sunShadowCascade,We.directionalShadowMatrix.value=j.state.directionalShadowMatrix,We.spotLightMatrix.value=j.state.spotLightMatrix,We.spotLightMap.value=j.state.spotLightMap,We.pointShadowMatrix.value=j.state.pointShadowMatrix),Z.numLightProbeGrids=dn(M.state.lightProbeGridArray),Z.currentProgram=_t,Z.uniformsList=null,_t}function ci(R,W,te,Z,j){let Pe=Xe.get(R),ke=Pe.currentProgram.id+","+Z+","+j,Le=Pe.programVariants.get(ke);return Le===void 0?(Le=ns(R,W,te),Pe.programVariants.set(ke,Le)):(Pe.currentProgram=Le,Pe.uniformsList=null,Pe.outputColorSpace=Z,Pe.toneMapping=j),Le}function $s(R){if(R.uniformsList===null){let W=R.currentProgram.getUniforms();R.uniformsList=Ga.seqWithValue(W.seq,R.uniforms)}return R.uniformsList}function co(R,W){let te=Xe.get(R);te.outputColorSpace=W.outputColorSpace,te.batching=W.batching,te.batchingColor=W.batchingColor,te.instancing=W.instancing,te.instancingColor=W.instancingColor,te.instancingMorph=W.instancingMorph,te.skinning=W.skinning,te.morphTargets=W.morphTargets,te.morphNormals=W.morphNormals,te.morphColors=W.morphColors,te.morphTargetsCount=W.morphTargetsCount,te.numClippingPlanes=W.numClippingPlanes,te.numIntersection=W.numClipIntersection,te.vertexAlphas=W.vertexAlphas,te.vertexTangents=W.vertexTangents,te.toneMapping=W.toneMapping}function ho(R,W,te,Z,j){W.isScene!==!0&&(W=nn),je.resetTextureUnits();let Pe=W.fog,ke=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?W.environment:null,Le=ce===null?N.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:Mt.workingColorSpace,Fe=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,$e=I.get(Z.envMap||ke,Fe),at=Z.vertexColors===!0&&!!te.attributes.color&&te.attributes.color.itemSize===4,_t=!!te.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),We=!!te.morphAttributes.position,yt=!!te.morphAttributes.normal,sn=!!te.morphAttributes.color,Ut=fs;Z.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Ut=N.toneMapping);let Ot=te.morphAttributes.position||te.morphAttributes.normal||te.morphAttributes.color,bn=Ot!==void 0?Ot.length:0,ze=Xe.get(Z),mn=M.state.lights;if(Rt===!0&&(Wt===!0||R!==ee)){let Bt=R===ee&&Z.id===K;re.setState(Z,R,Bt)}let wt=!1,bs=!1;Z.version===ze.__version?ze.needsLights&&ze.lightsStateVersion!==mn.state.version||j.isBatchedMesh&&ze.batching===!1||!j.isBatchedMesh&&ze.batching===!0||j.isBatchedMesh&&ze.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&ze.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&ze.instancing===!1||!j.isInstancedMesh&&ze.instancing===!0||j.isSkinnedMesh&&ze.skinning===!1||!j.isSkinnedMesh&&ze.skinning===!0||j.isInstancedMesh&&ze.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&ze.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&ze.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&ze.instancingMorph===!1&&j.morphTexture!==null||ze.envMap!==$e||Z.fog===!0&&ze.fog!==Pe||ze.numClippingPlanes!==void 0&&(ze.numClippingPlanes!==re.numPlanes||ze.numIntersection!==re.numIntersection)||ze.vertexAlphas!==at||ze.vertexTangents!==_t||ze.morphTargets!==We||ze.morphNormals!==yt||ze.morphColors!==sn||ze.morphTargetsCount!==bn||ze.numLightProbeGrids!==dn(M.state.lightProbeGridArray)?wt=!0:(ze.outputColorSpace!==Le||ze.toneMapping!==Ut)&&(bs=!0):(wt=!0,ze.__version=Z.version);let gn=ze.currentProgram;(wt===!0||bs===!0)&&(gn=bs===!0?ci(Z,W,j,Le,Ut):ns(Z,W,j),k&&Z.isNodeMaterial&&k.onUpdateProgram(Z,gn,ze));let ta=!1,is=!1,ws=!1,pt=gn.getUniforms(),on=ze.uniforms;if(Ce.useProgram(gn.program)&&(ta=!0,is=!0,ws=!0),Z.id!==K&&(K=Z.id,is=!0),ta||ee!==R){Ce.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),pt.setValue(V,"projectionMatrix",R.projectionMatrix),pt.setValue(V,"viewMatrix",R.matrixWorldInverse);let vn=pt.map.cameraPosition;vn!==void 0&&vn.setValue(V,Dt.setFromMatrixPosition(R.matrixWorld)),ht.logarithmicDepthBuffer&&pt.setValue(V,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&pt.setValue(V,"isOrthographic",R.isOrthographicCamera===!0),ee!==R&&(ee=R,is=!0,ws=!0)}if(ze.needsLights&&(mn.state.sunShadowMap.length>0&&pt.setValue(V,"sunShadowMap",mn.state.sunShadowMap,je),mn.state.directionalShadowMap.length>0&&pt.setValue(V,"directionalShadowMap",mn.state.directionalShadowMap,je),mn.state.spotShadowMap.length>0&&pt.setValue(V,"spotShadowMap",mn.state.spotShadowMap,je),mn.state.pointShadowMap.length>0&&pt.setValue(V,"pointShadowMap",mn.state.pointShadowMap,je)),j.isSkinnedMesh){pt.setOptional(V,j,"bindMatrix"),pt.setOptional(V,j,"bindMatrixInverse");let Bt=j.skeleton;Bt&&(Bt.boneTexture===null&&Bt.computeBoneTexture(),pt.setValue(V,"boneTexture",Bt.boneTexture,je))}j.isBatchedMesh&&(pt.setOptional(V,j,"batchingTexture"),pt.setValue(V,"batchingTexture",j._matricesTexture,je),pt.setOptional(V,j,"batchingIdTexture"),pt.setValue(V,"batchingIdTexture",j._indirectTexture,je),pt.setOptional(V,j,"batchingColorTexture"),j._colorsTexture!==null&&pt.setValue(V,"batchingColorTexture",j._colorsTexture,je));let qn=te.morphAttributes;if((qn.position!==void 0||qn.normal!==void 0||qn.color!==void 0)&&ae.update(j,te,gn),(is||ze.receiveShadow!==j.receiveShadow)&&(ze.receiveShadow=j.receiveShadow,pt.setValue(V,"receiveShadow",j.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&W.environment!==null&&(on.envMapIntensity.value=W.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=KS()),is){if(pt.setValue(V,"toneMappingExposure",N.toneMappingExposure),ze.needsLights&&Qr(on,ws),Pe&&Z.fog===!0&&Se.refreshFogUniforms(on,Pe),Se.refreshMaterialUniforms(on,Z,be,Te,M.state.transmissionRenderTarget[R.id]),ze.needsLights&&ze.numLightProbeGrids>0){let Bt=y,vn=0;for(let On of M.state.lightProbeGridArray)On.texture!==null&&(Bt.textures[vn]=On.texture,Bt.min[vn]=On.boundingBox.min,Bt.max[vn]=On.boundingBox.max,Bt.resolution[vn]=On.resolution,vn++);for(let On in Bt)Bt[On].length=vn;on.probesSH.value=Bt.textures,on.probesMin.value=Bt.min,on.probesMax.value=Bt.max,on.probesResolution.value=Bt.resolution}Ga.upload(V,$s(ze),on,je)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Ga.upload(V,$s(ze),on,je),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&pt.setValue(V,"center",j.center),pt.setValue(V,"modelViewMatrix",j.modelViewMatrix),pt.setValue(V,"normalMatrix",j.normalMatrix),pt.setValue(V,"modelMatrix",j.matrixWorld),Z.uniformsGroups!==void 0){let Bt=Z.uniformsGroups;for(let vn=0,On=Bt.length;vn<On;vn++){let Ll=Bt[vn];Ze.update(Ll,gn),Ze.bind(Ll,gn)}}return gn}function Qr(R,W){R.ambientLightColor.needsUpdate=W,R.lightProbe.needsUpdate=W,R.sunLights.needsUpdate=W,R.sunLightShadows.needsUpdate=W,R.directionalLights.needsUpdate=W,R.directionalLightShadows.needsUpdate=W,R.pointLights.needsUpdate=W,R.pointLightShadows.needsUpdate=W,R.spotLights.needsUpdate=W,R.spotLightShadows.needsUpdate=W,R.rectAreaLights.needsUpdate=W,R.hemisphereLights.needsUpdate=W}function Xs(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return $},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(R,W,te){let Z=Xe.get(R);Z.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Xe.get(R.texture).__webglTexture=W,Xe.get(R.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:te,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,W){let te=Xe.get(R);te.__webglFramebuffer=W,te.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(R,W=0,te=0){ce=R,Y=W,$=te;let Z=null,j=!1,Pe=!1;if(R){let Le=Xe.get(R);if(Le.__useDefaultFramebuffer!==void 0){Ce.bindFramebuffer(V.FRAMEBUFFER,Le.__webglFramebuffer),ne.copy(R.viewport),ue.copy(R.scissor),de=R.scissorTest,Ce.viewport(ne),Ce.scissor(ue),Ce.setScissorTest(de),K=-1;return}else if(Le.__webglFramebuffer===void 0)je.setupRenderTarget(R);else if(Le.__hasExternalTextures)je.rebindTextures(R,Xe.get(R.texture).__webglTexture,Xe.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let at=R.depthTexture;if(Le.__boundDepthTexture!==at){if(at!==null&&Xe.has(at)&&(R.width!==at.image.width||R.height!==at.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");je.setupDepthRenderbuffer(R)}}let Fe=R.texture;(Fe.isData3DTexture||Fe.isDataArrayTexture||Fe.isCompressedArrayTexture)&&(Pe=!0);let $e=Xe.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray($e[W])?Z=$e[W][te]:Z=$e[W],j=!0):R.samples>0&&je.useMultisampledRTT(R)===!1?Z=Xe.get(R).__webglMultisampledFramebuffer:Array.isArray($e)?Z=$e[te]:Z=$e,ne.copy(R.viewport),ue.copy(R.scissor),de=R.scissorTest}else ne.copy(Ie).multiplyScalar(be).floor(),ue.copy(rt).multiplyScalar(be).floor(),de=dt;if(te!==0&&(Z=B),Ce.bindFramebuffer(V.FRAMEBUFFER,Z)&&Ce.drawBuffers(R,Z),Ce.viewport(ne),Ce.scissor(ue),Ce.setScissorTest(de),j){let Le=Xe.get(R.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+W,Le.__webglTexture,te)}else if(Pe){let Le=W;for(let Fe=0;Fe<R.textures.length;Fe++){let $e=Xe.get(R.textures[Fe]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+Fe,$e.__webglTexture,te,Le)}}else if(R!==null&&te!==0){let Le=Xe.get(R.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Le.__webglTexture,te)}K=-1};function ea(R){let W=Xe.get(R);return(W.__readFormat!==R.format||W.__readType!==R.type)&&(W.__readFormat=R.format,W.__readType=R.type,W.__formatReadable=ht.textureFormatReadable(R.format),W.__typeReadable=ht.textureTypeReadable(R.type)),W}this.readRenderTargetPixels=function(R,W,te,Z,j,Pe,ke,Le=0){if(!(R&&R.isWebGLRenderTarget)){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Fe=Xe.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&ke!==void 0&&(Fe=Fe[ke],Array.isArray(Fe)&&(Fe=Fe[0])),Fe){Ce.bindFramebuffer(V.FRAMEBUFFER,Fe);try{let $e=R.textures[Le],at=$e.format,_t=$e.type;R.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Le);let We=ea($e);if(We.__formatReadable===!1){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(We.__typeReadable===!1){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=R.width-Z&&te>=0&&te<=R.height-j&&V.readPixels(W,te,Z,j,we.convert(at),we.convert(_t),Pe)}finally{let $e=ce!==null?Xe.get(ce).__webglFramebuffer:null;Ce.bindFramebuffer(V.FRAMEBUFFER,$e)}}},this.readRenderTargetPixelsAsync=async function(R,W,te,Z,j,Pe,ke,Le=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Fe=Xe.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&ke!==void 0&&(Fe=Fe[ke],Array.isArray(Fe)&&(Fe=Fe[0])),Fe)if(W>=0&&W<=R.width-Z&&te>=0&&te<=R.height-j){Ce.bindFramebuffer(V.FRAMEBUFFER,Fe);let $e=R.textures[Le],at=$e.format,_t=$e.type;R.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Le);let We=ea($e);if(We.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(We.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let yt=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,yt),V.bufferData(V.PIXEL_PACK_BUFFER,Pe.byteLength,V.STREAM_READ),V.readPixels(W,te,Z,j,we.convert(at),we.convert(_t),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let sn=ce!==null?Xe.get(ce).__webglFramebuffer:null;Ce.bindFramebuffer(V.FRAMEBUFFER,sn);let Ut=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await km(V,Ut,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,yt),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,Pe),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(yt),V.deleteSync(Ut),Pe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,W=null,te=0){let Z=Math.pow(2,-te),j=Math.floor(R.image.width*Z),Pe=Math.floor(R.image.height*Z),ke=W!==null?W.x:0,Le=W!==null?W.y:0;je.setTexture2D(R,0),V.copyTexSubImage2D(V.TEXTURE_2D,te,0,0,ke,Le,j,Pe),Ce.unbindTexture()},this.copyTextureToTexture=function(R,W,te=null,Z=null,j=0,Pe=0){let ke,Le,Fe,$e,at,_t,We,yt,sn,Ut=R.isCompressedTexture?R.mipmaps[Pe]:R.image;if(te!==null)ke=te.max.x-te.min.x,Le=te.max.y-te.min.y,Fe=te.isBox3?te.max.z-te.min.z:1,$e=te.min.x,at=te.min.y,_t=te.isBox3?te.min.z:0;else{let pt=Math.pow(2,-j);ke=Math.floor(Ut.width*pt),Le=Math.floor(Ut.height*pt),R.isDataArrayTexture?Fe=Ut.depth:R.isData3DTexture?Fe=Math.floor(Ut.depth*pt):Fe=1,$e=0,at=0,_t=0}Z!==null?(We=Z.x,yt=Z.y,sn=Z.z):(We=0,yt=0,sn=0);let Ot=we.convert(W.format),bn=we.convert(W.type),ze;W.isData3DTexture?(je.setTexture3D(W,0),ze=V.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(je.setTexture2DArray(W,0),ze=V.TEXTURE_2D_ARRAY):(je.setTexture2D(W,0),ze=V.TEXTURE_2D),Ce.activeTexture(V.TEXTURE0),Ce.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,W.flipY),Ce.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),Ce.pixelStorei(V.UNPACK_ALIGNMENT,W.unpackAlignment);let mn=Ce.getParameter(V.UNPACK_ROW_LENGTH),wt=Ce.getParameter(V.UNPACK_IMAGE_HEIGHT),bs=Ce.getParameter(V.UNPACK_SKIP_PIXELS),gn=Ce.getParameter(V.UNPACK_SKIP_ROWS),ta=Ce.getParameter(V.UNPACK_SKIP_IMAGES);Ce.pixelStorei(V.UNPACK_ROW_LENGTH,Ut.width),Ce.pixelStorei(V.UNPACK_IMAGE_HEIGHT,Ut.height),Ce.pixelStorei(V.UNPACK_SKIP_PIXELS,$e),Ce.pixelStorei(V.UNPACK_SKIP_ROWS,at),Ce.pixelStorei(V.UNPACK_SKIP_IMAGES,_t);let is=R.isDataArrayTexture||R.isData3DTexture,ws=W.isDataArrayTexture||W.isData3DTexture;if(R.isDepthTexture){let pt=Xe.get(R),on=Xe.get(W),qn=Xe.get(pt.__renderTarget),Bt=Xe.get(on.__renderTarget);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,qn.__webglFramebuffer),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,Bt.__webglFramebuffer);for(let vn=0;vn<Fe;vn++)is&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Xe.get(R).__webglTexture,j,_t+vn),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Xe.get(W).__webglTexture,Pe,sn+vn)),V.blitFramebuffer($e,at,$e+ke,at+Le,We,yt,We+ke,yt+Le,V.DEPTH_BUFFER_BIT,V.NEAREST);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(j!==0||R.isRenderTargetTexture||Xe.has(R)){let pt=Xe.get(R),on=Xe.get(W);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,L),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,H);for(let qn=0;qn<Fe;qn++)is?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,pt.__webglTexture,j,_t+qn):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,pt.__webglTexture,j),ws?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,on.__webglTexture,Pe,sn+qn):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,on.__webglTexture,Pe),j!==0?V.blitFramebuffer($e,at,$e+ke,at+Le,We,yt,We+ke,yt+Le,V.COLOR_BUFFER_BIT,V.NEAREST):ws?V.copyTexSubImage3D(ze,Pe,We,yt,sn+qn,$e,at,ke,Le):V.copyTexSubImage2D(ze,Pe,We,yt,$e,at,ke,Le);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else ws?R.isDataTexture||R.isData3DTexture?V.texSubImage3D(ze,Pe,We,yt,sn,ke,Le,Fe,Ot,bn,Ut.data):W.isCompressedArrayTexture?V.compressedTexSubImage3D(ze,Pe,We,yt,sn,ke,Le,Fe,Ot,Ut.data):V.texSubImage3D(ze,Pe,We,yt,sn,ke,Le,Fe,Ot,bn,Ut):R.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,Pe,We,yt,ke,Le,Ot,bn,Ut.data):R.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,Pe,We,yt,Ut.width,Ut.height,Ot,Ut.data):V.texSubImage2D(V.TEXTURE_2D,Pe,We,yt,ke,Le,Ot,bn,Ut);Ce.pixelStorei(V.UNPACK_ROW_LENGTH,mn),Ce.pixelStorei(V.UNPACK_IMAGE_HEIGHT,wt),Ce.pixelStorei(V.UNPACK_SKIP_PIXELS,bs),Ce.pixelStorei(V.UNPACK_SKIP_ROWS,gn),Ce.pixelStorei(V.UNPACK_SKIP_IMAGES,ta),Pe===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&V.generateMipmap(ze),Ce.unbindTexture()},this.initRenderTarget=function(R){Xe.get(R).__webglFramebuffer===void 0&&je.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?je.setTextureCube(R,0):R.isData3DTexture?je.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?je.setTexture2DArray(R,0):je.setTexture2D(R,0),Ce.unbindTexture()},this.resetState=function(){Y=0,$=0,ce=null,Ce.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Di}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Mt._getUnpackColorSpace()}};var bg={type:"change"},sf={type:"start"},Sg={type:"end"},Uh=new Ir,wg=new yi,jS=Math.cos(70*zd.DEG2RAD),Mn=new G,li=2*Math.PI,Lt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},nf=1e-6,Oh=class extends tl{constructor(e,t=null){super(e,t),this.state=Lt.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:lr.ROTATE,MIDDLE:lr.DOLLY,RIGHT:lr.PAN},this.touches={ONE:cr.ROTATE,TWO:cr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new Qn,this._lastTargetPosition=new G,this._quat=new Qn().setFromUnitVectors(e.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Fa,this._sphericalDelta=new Fa,this._scale=1,this._panOffset=new G,this._rotateStart=new Ge,this._rotateEnd=new Ge,this._rotateDelta=new Ge,this._panStart=new Ge,this._panEnd=new Ge,this._panDelta=new Ge,this._dollyStart=new Ge,this._dollyEnd=new Ge,this._dollyDelta=new Ge,this._dollyDirection=new G,this._mouse=new Ge,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=QS.bind(this),this._onPointerDown=JS.bind(this),this._onPointerUp=eM.bind(this),this._onContextMenu=oM.bind(this),this._onMouseWheel=iM.bind(this),this._onKeyDown=sM.bind(this),this._onTouchStart=rM.bind(this),this._onTouchMove=aM.bind(this),this._onMouseDown=tM.bind(this),this._onMouseMove=nM.bind(this),this._interceptControlDown=lM.bind(this),this._interceptControlUp=cM.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Lt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(bg),this.update(),this.state=Lt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Mn.copy(t).sub(this.target),Mn.applyQuaternion(this._quat),this._spherical.setFromVector3(Mn),this.autoRotate&&this.state===Lt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=li:n>Math.PI&&(n-=li),s<-Math.PI?s+=li:s>Math.PI&&(s-=li),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let a=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=a!=this._spherical.radius}if(Mn.setFromSpherical(this._spherical),Mn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let a=null;if(this.object.isPerspectiveCamera){let o=Mn.length();a=this._clampDistance(o*this._scale);let l=o-a;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let o=new G(this._mouse.x,this._mouse.y,0);o.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new G(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(o),this.object.updateMatrixWorld(),a=Mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;a!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(a).add(this.object.position):(Uh.origin.copy(this.object.position),Uh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Uh.direction))<jS?this.object.lookAt(this.target):(wg.setFromNormalAndCoplanarPoint(this.object.up,this.target),Uh.intersectPlane(wg,this.target))))}else if(this.object.isOrthographicCamera){let a=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),a!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>nf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>nf||this._lastTargetPosition.distanceToSquared(this.target)>nf?(this.dispatchEvent(bg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?li/60*this.autoRotateSpeed*e:li/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Mn.setFromMatrixColumn(t,0),Mn.multiplyScalar(-e),this._panOffset.add(Mn)}_panUp(e,t){this.screenSpacePanning===!0?Mn.setFromMatrixColumn(t,1):(Mn.setFromMatrixColumn(t,0),Mn.crossVectors(this.object.up,Mn)),Mn.multiplyScalar(e),this._panOffset.add(Mn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mn.copy(s).sub(this.target);let r=Mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,a=n.width,o=n.height;this._mouse.x=s/a*2-1,this._mouse.y=-(r/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(li*this._rotateDelta.x/t.clientHeight),this._rotateUp(li*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(li*this._rotateDelta.x/t.clientHeight),this._rotateUp(li*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(e.pageX+t.x)*.5,o=(e.pageY+t.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ge,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function JS(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function QS(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function eM(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Sg),this.state=Lt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function tM(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case lr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Lt.DOLLY;break;case lr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Lt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Lt.ROTATE}break;case lr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Lt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Lt.PAN}break;default:this.state=Lt.NONE}this.state!==Lt.NONE&&this.dispatchEvent(sf)}function nM(i){switch(this.state){case Lt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Lt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Lt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function iM(i){this.enabled===!1||this.enableZoom===!1||this.state!==Lt.NONE||(i.preventDefault(),this.dispatchEvent(sf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Sg))}function sM(i){this.enabled!==!1&&this._handleKeyDown(i)}function rM(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case cr.ROTATE:if(this.enableRotate===!1){this.state=Lt.NONE;break}this._handleTouchStartRotate(i),this.state=Lt.TOUCH_ROTATE;break;case cr.PAN:if(this.enablePan===!1){this.state=Lt.NONE;break}this._handleTouchStartPan(i),this.state=Lt.TOUCH_PAN;break;default:this.state=Lt.NONE}break;case 2:switch(this.touches.TWO){case cr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Lt.TOUCH_DOLLY_PAN;break;case cr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Lt.TOUCH_DOLLY_ROTATE;break;default:this.state=Lt.NONE}break;default:this.state=Lt.NONE}this.state!==Lt.NONE&&this.dispatchEvent(sf)}function aM(i){switch(this._trackPointer(i),this.state){case Lt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Lt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Lt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Lt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Lt.NONE}}function oM(i){this.enabled!==!1&&i.preventDefault()}function lM(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function cM(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var zr=new G(0,1,0),hM=16,uM=matchMedia("(max-width: 40rem)"),dM=13,Mg={space:[1,.75,.5],front:[1,0,0],side:[0,1,0],top:[0,0,1]},Vr=class{mesh;constructor(e,t,n){this.mesh=new hn(new Da(n,n,1,10),t),e.add(this.mesh)}between(e,t){let n=t.clone().sub(e),s=n.length()||1e-6;this.mesh.position.copy(e).addScaledVector(n,.5),this.mesh.quaternion.setFromUnitVectors(zr,n.divideScalar(s)),this.mesh.scale.set(1,s,1)}};function fM(i,e){let t=[];for(let n=0;n<=16*e;n++){let s=n/(16*e),r=2*Math.PI*e*s;t.push(new G(i*Math.cos(r),s,i*Math.sin(r)))}return new fn().setFromPoints(t)}var dr=class{element=h("div",{class:"mechanism"});canvas=h("canvas",{tabindex:"0","aria-label":St("mechanism")});state=h("div",{class:"state"});names=h("div",{class:"names"});legend=h("ul",{class:"legend"});space=new Uo;camera=new Nr;renderer=null;controls=null;group=new Fn;level=new Fn;shown=null;motion=null;points=[];update=[];spin=new G(0,1,0);now={body:0,travel:0,ground:0,load:1,time:0};wheelGroup=new Fn;pathGroup=new Fn;labels=[];wide=[];named=[];isDirty=!0;due=0;isLost=!1;isSeen=!1;size=300;reach=[300,300];centres=null;turned=[];chosen=null;halo=null;grabbed=null;way="view";constructor(e=!1){let t=h("div",{class:"group",role:"group","aria-label":St("view")});for(let l of Object.keys(Mg))t.append(h("button",{type:"button",click:()=>this.look(l)},St(l)));let n=pi(St("wheel"),!0,l=>{this.wheelGroup.visible=l,this.stale()}),s=pi(St("paths"),e,l=>{this.pathGroup.visible=l,this.stale()}),r=e&&!uM.matches,a=pi(St("names"),r,l=>{this.names.hidden=!l,this.stale()});this.names.hidden=!r,this.pathGroup.visible=e,this.element.append(h("div",{class:"bar"},t,h("div",{class:"group"},n,s,a)),h("div",{class:"stage"},this.canvas,this.names,this.state)),e&&this.element.append(this.legend),this.space.add(new el(16777215,1.9),this.group,this.level);let o=new Qo(16777215,1.9);o.position.set(.6,.3,1),this.space.add(o),this.camera.up.set(0,0,1),this.controls=new Oh(this.camera,this.canvas),this.controls.enableZoom=!1,this.canvas.addEventListener("focus",()=>{this.controls.enableZoom=!0}),this.canvas.addEventListener("blur",()=>{this.controls.enableZoom=!1}),this.canvas.addEventListener("pointerdown",()=>this.canvas.focus()),this.canvas.addEventListener("dblclick",()=>this.look("space")),this.controls.addEventListener("change",()=>{this.stale()}),this.canvas.parentElement.addEventListener("pointerdown",l=>this.take(l),{capture:!0}),new ResizeObserver(()=>this.resize()).observe(this.canvas.parentElement),ha(()=>this.giveBack()),new IntersectionObserver(l=>{this.isSeen=l.some(c=>c.isIntersecting),this.isDirty&&this.stale()},{rootMargin:"300px"}).observe(this.element)}begin(){if(this.renderer||this.isLost)return!this.isLost;try{this.renderer=new Nh({canvas:this.canvas,antialias:_o(),alpha:!0}),this.renderer.setPixelRatio(_o()?Math.min(devicePixelRatio,2):1)}catch{return this.isLost=!0,this.state.textContent=St("noWebGL"),!1}return this.resize(),!0}giveBack(){this.isLost=!0,this.shown=null,this.controls?.dispose(),this.space.traverse(e=>{(e instanceof hn||e instanceof us)&&e.geometry.dispose()}),this.renderer?.dispose(),this.renderer?.forceContextLoss(),this.renderer=null}show(e,t){let n=this.shown;this.motion=t,this.shown=e,n===null||Tg(n)!==Tg(e)?(this.build(e),this.look("space")):n!==e&&this.redraw(e),this.set(this.now)}set(e){let t=this.shown;if(this.now=e,!t)return;let{travel:n}=e,s=t.travel,r=s.length,a=Math.min(xo(s,n),Math.max(r-2,0)),o=Math.min(a+1,r-1),l=o>a?(n-s[a])/(s[o]-s[a]):0;t.points.forEach((d,f)=>{let p=d[a],g=d[o];this.points[f].set(p[0]+l*(g[0]-p[0]),p[1]+l*(g[1]-p[1]),p[2]+l*(g[2]-p[2])+e.body)});let c=t.spin[a],u=t.spin[o];this.spin.set(c[0]+l*(u[0]-c[0]),c[1]+l*(u[1]-c[1]),c[2]+l*(u[2]-c[2])).normalize(),this.tilt(t,l<.5?a:o);for(let d of this.update)d();this.turnAbout(l<.5?a:o),this.isLost||(this.state.textContent=e.load>0?"":St("noContact")),this.stale()}tilt(e,t){let n=this.now.roll??0,s=e.contact[t],r=e.contact[xo(e.travel,0)]?.[2]??0;this.group.rotation.x=n,this.group.position.set(0,r*Math.sin(n),r*(1-Math.cos(n))),this.group.updateMatrixWorld(),n&&s&&(this.now={...this.now,ground:new G(s[0],s[1],s[2]).applyMatrix4(this.group.matrixWorld).z})}outside(e,t=new G){return t.copy(e).applyMatrix4(this.group.matrixWorld)}stale(){this.isDirty=!0,this.due||=requestAnimationFrame(()=>{this.due=0,this.draw()})}draw(){!this.isDirty||!this.isSeen||!this.shown||!this.begin()||(this.isDirty=!1,this.renderer.render(this.space,this.camera),this.names.hidden||this.place())}showCentres(e){this.centres=e,this.set(this.now)}choose(e){this.chosen=e,this.set(this.now)}turnAbout(e){let t=this.shown,n=t.contact[e];for(let{line:r,mark:a,of:o}of this.turned){let l=this.centres?.[o][e];if(r.visible=a.visible=!!l&&!!n,!l||!n)continue;let c=new G(n[0],n[1],n[2]+this.now.body),u=o==="side"?new G(l[0],c.y,l[1]):new G(c.x,l[0],l[1]);u.z+=this.now.body,r.geometry.setFromPoints([c,u]),a.position.copy(u)}if(!this.halo)return;let s=this.chosen===null?-1:t.names.indexOf(this.chosen);this.halo.visible=s>=0,s>=0&&this.halo.position.copy(this.points[s])}take(e){let t=this.shown;if(!this.grabbed||!t||e.button!==0||e.target!==this.canvas)return;let n=this.canvas.getBoundingClientRect(),s=new G,r=hM,a=-1;if(t.names.forEach((g,_)=>{if(t.feet.includes(_))return;this.outside(this.points[_],s).project(this.camera);let m=Math.hypot(n.left+(.5+.5*s.x)*n.width-e.clientX,n.top+(.5-.5*s.y)*n.height-e.clientY);m<r&&(r=m,a=_)}),a<0)return;e.stopPropagation(),e.preventDefault(),this.canvas.focus({preventScroll:!0});let o=t.names[a],l=(this.camera.right-this.camera.left)/this.camera.zoom/n.width,c=new G().setFromMatrixColumn(this.camera.matrixWorld,0),u=new G().setFromMatrixColumn(this.camera.matrixWorld,1);for(let g of[c,u])g.applyQuaternion(this.group.quaternion.clone().invert());let d=g=>{let _=l*(g.clientX-e.clientX),m=-l*(g.clientY-e.clientY);if(this.way==="view")return c.clone().multiplyScalar(_).addScaledVector(u,m).toArray();let v="xyz".indexOf(this.way),x=c.getComponent(v),S=u.getComponent(v),y=x*x+S*S,T=[0,0,0];return y>.02&&(T[v]=(_*x+m*S)/y),T},f=g=>this.grabbed?.(o,d(g),!1),p=g=>{removeEventListener("pointermove",f),removeEventListener("pointerup",p),removeEventListener("pointercancel",p),this.grabbed?.(o,g.type==="pointerup"?d(g):[0,0,0],!0)};addEventListener("pointermove",f),addEventListener("pointerup",p),addEventListener("pointercancel",p),this.grabbed(o,[0,0,0],!1)}look(e){if(!this.controls||!this.shown)return;let[t,n,s]=Mg[e],r=this.shown.side,a=new G(1/0,1/0,1/0),o=a.clone().negate();for(let _ of this.points)a.min(_),o.max(_);let{centre:l,radius:c,width:u}=this.shown.wheel,d=this.points[l];a.min(new G(d.x-c,d.y-u/2,d.z-c)),o.max(new G(d.x+c,d.y+u/2,d.z+c));let f=a.clone().add(o).multiplyScalar(.5);this.size=.5*a.distanceTo(o),this.controls.target.copy(f),this.camera.position.copy(f).add(new G(t,r*n,s+(e==="top"?0:.001)).normalize().multiplyScalar(6*this.size)),e==="top"&&(this.camera.position.x-=.01*this.size),this.camera.zoom=1,this.camera.near=.1,this.camera.far=20*this.size,this.controls.update(),this.camera.updateMatrixWorld();let p=o.clone().sub(a).multiplyScalar(.5),g=new G;this.reach=[0,1].map(_=>(g.setFromMatrixColumn(this.camera.matrixWorld,_),Math.abs(g.x)*p.x+Math.abs(g.y)*p.y+Math.abs(g.z)*p.z)),this.frame(),this.stale()}repaint(){this.shown&&(this.build(this.shown),this.set(this.now))}frame(){let{clientWidth:e,clientHeight:t}=this.canvas.parentElement,[n,s]=this.reach,r=Math.max(e,1)/Math.max(t,1),a=1.15*Math.max(s,n/r),o=a*r;Object.assign(this.camera,{left:-o,right:o,top:a,bottom:-a}),this.camera.updateProjectionMatrix()}resize(){let{clientWidth:e,clientHeight:t}=this.canvas.parentElement;!this.renderer||e<10||t<10||(this.renderer.setSize(e,t,!1),this.frame(),this.stale())}redraw(e){for(let[t,n]of this.pathGroup.children.entries())n.geometry.setFromPoints(Eg(t?e.contact:e.points[e.wheel.centre]))}build(e){for(let r of[this.group,this.level])this.space.remove(r),r.traverse(a=>{(a instanceof hn||a instanceof us)&&a.geometry.dispose()});this.group=new Fn,this.level=new Fn,this.space.add(this.group,this.level),this.update=[],this.points=e.points.map(r=>new G(r[0][0],r[0][1],r[0][2]));let t=e.wheel.radius/22,n=xt("ink"),s=r=>r==="#22262b"?n:r;for(let r of e.parts){let a=new ei({color:new Qe(s(r.colour))});if(r.coil){this.coil(a,r.points[0],r.points[1],e,t);continue}let o=r.points.map((l,c)=>[c,c+1]).slice(0,-1);r.plate&&o.push([r.points.length-1,0]);for(let[l,c]of o){let u=new Vr(this.group,a,t);this.update.push(()=>u.between(this.points[r.points[l]],this.points[r.points[c]]))}r.plate&&r.points.length>=3&&this.plate(r.points,s(r.colour))}for(let[r,[a,o,l,,c]]of e.brackets.entries()){let u=new Vr(this.group,new ei({color:new Qe(s(c))}),.5*t);this.update.push(()=>u.between(this.points[a],this.points[o].clone().lerp(this.points[l],this.shown.brackets[r][3])))}this.strut(e,t),this.joints(e,t),this.wheel(e),this.road(e),this.axis(e),this.paths(e),this.marks(t),this.named=e.names.map((r,a)=>a).filter(r=>!e.feet.includes(r)),this.wide=[],this.names.replaceChildren(...this.labels=this.named.map(r=>h("span",{},e.names[r].replaceAll("_"," ")))),this.legend.replaceChildren(...[...e.parts,{words:St("strut"),colour:e.strut.colour}].map(r=>{let a=h("i",{class:"swatch"});return a.style.background=s(r.colour),h("li",{},a,r.words)}))}marks(e){let t={front:xt("other-1"),side:xt("other-3"),roll:xt("accent")};this.turned=Object.keys(t).map(n=>{let s=new us(new fn().setFromPoints([zr,zr]),new Ds({color:new Qe(t[n])})),r=new hn(n==="roll"?new ks(3*e,3*e,3*e):new Dr(2*e,12,8),new ei({color:new Qe(t[n])}));return s.frustumCulled=!1,s.visible=r.visible=!1,this.group.add(s,r),{line:s,mark:r,of:n}}),this.halo=new hn(new Dr(2.6*e,16,12),new ei({color:new Qe(xt("accent")),transparent:!0,opacity:.7})),this.halo.visible=!1,this.group.add(this.halo)}axis(e){if(!e.axis)return;let[t,n]=e.axis,s=new fn().setFromPoints([zr,zr]),r=new us(s,new Zo({color:new Qe(xt("muted")),dashSize:12,gapSize:7}));r.frustumCulled=!1,this.group.add(r),this.update.push(()=>{let a=this.points[t],o=this.points[n].clone().sub(a);s.setFromPoints([a.clone().addScaledVector(o,-.3),a.clone().addScaledVector(o,1.3)]),r.computeLineDistances()})}paths(e){let t=this.pathGroup.visible,n=new Ds({color:new Qe(xt("accent"))});this.pathGroup=new Fn,this.pathGroup.visible=t;for(let s of[e.points[e.wheel.centre],e.contact])this.pathGroup.add(new us(new fn().setFromPoints(Eg(s)),n));this.group.add(this.pathGroup),this.update.push(()=>this.pathGroup.position.setZ(this.now.body))}plate(e,t){let n=new fn,s=e.length-2,r=new Float32Array(9*s);n.setAttribute("position",new si(r,3));let a=new ei({color:new Qe(t),transparent:!0,opacity:.25,side:ai,depthWrite:!1}),o=new hn(n,a);o.frustumCulled=!1,this.group.add(o),this.update.push(()=>{for(let l=0;l<s;l++)[e[0],e[l+1],e[l+2]].forEach((c,u)=>this.points[c].toArray(r,9*l+3*u));n.attributes.position.needsUpdate=!0,n.computeVertexNormals()})}strut(e,t){let n=new ei({color:new Qe(e.strut.colour)}),s=new Vr(this.group,n,.6*t),r=new Vr(this.group,n,1.7*t),[a,o]=e.strut.damper;this.update.push(()=>{let u=this.points[a],d=this.points[o];s.between(u,d),r.between(u,u.clone().addScaledVector(d.clone().sub(u).normalize(),e.strut.tube))});let[l,c]=e.strut.spring;this.coil(n,l,c,e,t)}coil(e,t,n,s,r){let a=fM(s.strut.radius,s.strut.coils),o=new Na(pM(a)),l=new Yo(o,14*s.strut.coils,1,5),c=l.attributes.position.array.slice(),u=o.getSpacedPoints(14*s.strut.coils),d=new hn(l,e);this.group.add(d);let f=.55*r,p=new Qn;this.update.push(()=>{let g=this.points[t],_=this.points[n].clone().sub(g),m=_.length();p.setFromUnitVectors(zr,_.normalize());let v=l.attributes.position,x=new G,S=6;for(let y=0;y<v.count;y++){let T=u[Math.floor(y/S)];x.set(c[3*y]-T.x,0,c[3*y+2]-T.z);let M=c[3*y+1]-T.y;x.multiplyScalar(f).add(new G(T.x,(.08+.84*T.y)*m+f*M,T.z)),x.applyQuaternion(p).add(g),v.setXYZ(y,x.x,x.y,x.z)}v.needsUpdate=!0,l.computeVertexNormals()}),d.frustumCulled=!1}joints(e,t){let n=new Dr(1.5*t,12,8),s=new ks(2.6*t,2.6*t,2.6*t),r=new ei({color:new Qe(xt("muted"))}),a=new ei({color:new Qe(xt("ink"))});e.names.forEach((o,l)=>{if(l===e.wheel.centre||e.feet.includes(l))return;let c=new hn(e.onBody[l]?s:n,e.onBody[l]?r:a);this.group.add(c),this.update.push(()=>c.position.copy(this.points[l]))})}wheel(e){let{radius:t,width:n,centre:s}=e.wheel,r=this.wheelGroup.visible;this.wheelGroup=new Fn,this.wheelGroup.visible=r,this.group.add(this.wheelGroup);let a=new ei({color:new Qe(xt("rubber")),transparent:!0,opacity:.3,depthWrite:!1,side:ai}),o=new hn(new Da(t,t,.8*n,48,1,!0),a),l=[-.4,.4].map(d=>{let f=new hn(new qo(.93*t,.07*t,8,48),a);return f.rotateX(Math.PI/2),f.position.y=d*n,f}),c=new Fn,u=new ei({color:new Qe(xt("rubber"))});for(let d=0;d<5;d++){let f=new Vr(c,u,t/60),p=2*Math.PI*d/5,g=.4*n*e.side;f.between(new G(.12*t*Math.cos(p),g,.12*t*Math.sin(p)),new G(.8*t*Math.cos(p),g,.8*t*Math.sin(p)))}this.wheelGroup.add(o,...l,c),this.update.push(()=>{this.wheelGroup.position.copy(this.points[s]);let d=this.spin.clone().multiplyScalar(e.side);this.wheelGroup.quaternion.setFromUnitVectors(zr,d);let f=this.motion?.road?this.motion.road.speed*this.now.time:0;c.rotation.y=f/t})}road(e){let t=2.4*e.wheel.radius,n=.8*e.wheel.width,s=121,r=new fn,a=new Float32Array(6*s),o=[];for(let f=0;f<s-1;f++)o.push(2*f,2*f+1,2*f+2,2*f+1,2*f+3,2*f+2);r.setAttribute("position",new si(a,3)),r.setIndex(o);let l=new hn(r,new ei({color:new Qe(xt("road")),side:ai}));l.frustumCulled=!1;let c=new fn,u=new Float32Array(12*(s-1));c.setAttribute("position",new si(u,3));let d=new zo(c,new Ds({color:new Qe(xt("muted"))}));d.frustumCulled=!1,this.level.add(l,d),this.update.push(()=>{let f=this.outside(this.points[e.wheel.centre]),p=this.motion?.road,g=p?p.speed*this.now.time:0;for(let _=0;_<s;_++){let m=-t+2*t*_/(s-1),v=p?mM(p,g+m):this.now.ground;a.set([f.x+m,f.y-n,v,f.x+m,f.y+n,v],6*_)}for(let _=0;_<s-1;_++)for(let m of[0,3])u.set([...a.subarray(6*_+m,6*_+m+3),...a.subarray(6*_+6+m,6*_+9+m)],12*_+2*m);r.attributes.position.needsUpdate=c.attributes.position.needsUpdate=!0,r.computeVertexNormals()})}place(){let{clientWidth:e,clientHeight:t}=this.canvas.parentElement,n=new G;(this.wide.length!==this.labels.length||this.wide.includes(0))&&(this.wide=this.labels.map(a=>a.offsetWidth));let{wide:s}=this,r=this.labels.map((a,o)=>{this.outside(this.points[this.named[o]],n).project(this.camera);let l=(.5+.5*n.x)*e,c=s[o];return{label:a,width:c,x:l+c+8<e?l+7:l-c-7,y:(.5-.5*n.y)*t-8}}).sort((a,o)=>a.y-o.y);r.forEach((a,o)=>{let l=r.slice(0,o).filter(c=>c.x<a.x+a.width&&a.x<c.x+c.width);a.y=Math.max(a.y,...l.map(c=>c.y+dM)),a.label.style.transform=`translate(${a.x}px, ${a.y}px)`})}};function Eg(i){return i.map(e=>new G(e[0],e[1],e[2]))}function Tg({points:i,spin:e,contact:t,travel:n,brackets:s,...r}){return JSON.stringify([r,s.map(([a,o,l])=>[a,o,l])])}function pM(i){let e=i.attributes.position;return Array.from({length:e.count},(t,n)=>new G(e.getX(n),e.getY(n),e.getZ(n)))}function mM(i,e){let{x:t,z:n}=i,s=t.length;if(e<=t[0])return n[0];if(e>=t[s-1])return n[s-1];let r=xo(t,e),a=t[r],o=t[r+1];return o>a?n[r]+(n[r+1]-n[r])*(e-a)/(o-a):n[r+1]}var gM="uplot",vM="u-hz",_M="u-vt",yM="u-title",xM="u-wrap",bM="u-under",wM="u-over",SM="u-axis",Wr="u-off",MM="u-select",EM="u-cursor-x",TM="u-cursor-y",AM="u-cursor-pt",CM="u-legend",RM="u-live",PM="u-inline",LM="u-series",IM="u-marker",Ag="u-label",DM="u-value",ml="width",gl="height";var Cg="bottom",Wa="left",rf="right",wf="#000",Rg=wf+"0",af="mousemove",Pg="mousedown",of="mouseup",Lg="mouseenter",Ig="mouseleave",Dg="dblclick",NM="resize",kM="scroll",Ng="change",Hh="dppxchange",Sf="--",ja=typeof window<"u",df=ja?document:null,Xa=ja?window:null,FM=ja?navigator:null,It,Bh;function ff(){let i=devicePixelRatio;It!=i&&(It=i,Bh&&mf(Ng,Bh,ff),Bh=matchMedia(`(min-resolution: ${It-.001}dppx) and (max-resolution: ${It+.001}dppx)`),$r(Ng,Bh,ff),Xa.dispatchEvent(new CustomEvent(Hh)))}function Si(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function pf(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Jt(i,e,t){i.style[e]=t+"px"}function ji(i,e,t,n){let s=df.createElement(i);return e!=null&&Si(s,e),t?.insertBefore(s,n),s}function ki(i,e){return ji("div",i,e)}var kg=new WeakMap;function gs(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",a=kg.get(i);r!=a&&(i.style.transform=r,kg.set(i,r),e<0||t<0||e>n||t>s?Si(i,Wr):pf(i,Wr))}var Fg=new WeakMap;function Ug(i,e,t){let n=e+t,s=Fg.get(i);n!=s&&(Fg.set(i,n),i.style.background=e,i.style.borderColor=t)}var Og=new WeakMap;function Bg(i,e,t,n){let s=e+""+t,r=Og.get(i);s!=r&&(Og.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Mf={passive:!0},UM={...Mf,capture:!0};function $r(i,e,t,n){e.addEventListener(i,t,n?UM:Mf)}function mf(i,e,t,n){e.removeEventListener(i,t,Mf)}ja&&ff();function Ji(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:Mi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function f0(i){return(t,n,s)=>{let r=-1,a=-1;for(let o=n;o<=s;o++)if(i(t[o])){r=o;break}for(let o=s;o>=n;o--)if(i(t[o])){a=o;break}return[r,a]}}var p0=i=>i!=null,m0=i=>i!=null&&i>0,Xh=f0(p0),OM=f0(m0);function BM(i,e,t,n=0,s=!1){let r=s?OM:Xh,a=s?m0:p0;[e,t]=r(i,e,t);let o=i[e],l=i[e];if(e>-1)if(n==1)o=i[e],l=i[t];else if(n==-1)o=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];a(u)&&(u<o?o=u:u>l&&(l=u))}return[o??Gt,l??-Gt]}function qh(i,e,t,n){let s=Gg(i),r=Gg(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let a=t==10?Bs:g0,o=s==1?Mi:Fi,l=r==1?Fi:Mi,c=o(a(Tn(i))),u=l(a(Tn(e))),d=qa(t,c),f=qa(t,u);return t==10&&(c<0&&(d=Ht(d,-c)),u<0&&(f=Ht(f,-u))),n||t==2?(i=d*s,e=f*r):(i=x0(i,d),e=Yh(e,f)),[i,e]}function Ef(i,e,t,n){let s=qh(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Tf=.1,zg={mode:3,pad:Tf},_l={pad:0,soft:null,mode:0},zM={min:_l,max:_l};function Wh(i,e,t,n){return Zh(t)?Vg(i,e,t):(_l.pad=t,_l.soft=n?0:null,_l.mode=n?3:0,Vg(i,e,zM))}function Ct(i,e){return i??e}function VM(i,e,t){for(e=Ct(e,0),t=Ct(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Vg(i,e,t){let n=t.min,s=t.max,r=Ct(n.pad,0),a=Ct(s.pad,0),o=Ct(n.hard,-Gt),l=Ct(s.hard,Gt),c=Ct(n.soft,Gt),u=Ct(s.soft,-Gt),d=Ct(n.mode,0),f=Ct(s.mode,0),p=e-i,g=Bs(p),_=ni(Tn(i),Tn(e)),m=Bs(_),v=Tn(m-g);(p<1e-24||v>10)&&(p=0,(i==0||e==0)&&(p=1e-24,d==2&&c!=Gt&&(r=0),f==2&&u!=-Gt&&(a=0)));let x=p||_||1e3,S=Bs(x),y=qa(10,Mi(S)),T=x*(p==0?i==0?.1:1:r),M=Ht(x0(i-T,y/10),24),b=i>=c&&(d==1||d==3&&M<=c||d==2&&M>=c)?c:Gt,A=ni(o,M<b&&i>=b?b:Qi(b,M)),O=x*(p==0?e==0?.1:1:a),N=Ht(Yh(e+O,y/10),24),P=e<=u&&(f==1||f==3&&N>=u||f==2&&N<=u)?u:-Gt,k=Qi(l,N>P&&e<=P?P:ni(P,N));return A==k&&A==0&&(k=100),[A,k]}var GM=new Intl.NumberFormat(ja?FM.language:"en-US"),Af=i=>GM.format(i),Ei=Math,Gh=Ei.PI,Tn=Ei.abs,Mi=Ei.floor,En=Ei.round,Fi=Ei.ceil,Qi=Ei.min,ni=Ei.max,qa=Ei.pow,Gg=Ei.sign,Bs=Ei.log10,g0=Ei.log2,HM=(i,e=1)=>Ei.sinh(i)*e,lf=(i,e=1)=>Ei.asinh(i/e),Gt=1/0;function Hg(i){return(Bs((i^i>>31)-(i>>31))|0)+1}function gf(i,e,t){return Qi(ni(i,e),t)}function v0(i){return typeof i=="function"}function Et(i){return v0(i)?i:()=>i}var WM=()=>{},_0=i=>i,y0=(i,e)=>e,$M=i=>null,Wg=i=>!0,$g=(i,e)=>i==e,XM=/\.\d*?(?=9{6,}|0{6,})/gm,Xr=i=>{if(w0(i)||pr.has(i))return i;let e=`${i}`,t=e.match(XM);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Xr(s)}e${r}`}return Ht(i,n)};function Gr(i,e){return Xr(Ht(Xr(i/e))*e)}function Yh(i,e){return Xr(Fi(Xr(i/e))*e)}function x0(i,e){return Xr(Mi(Xr(i/e))*e)}function Ht(i,e=0){if(w0(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return En(n)/t}var pr=new Map;function b0(i){return((""+i).split(".")[1]||"").length}function xl(i,e,t,n){let s=[],r=n.map(b0);for(let a=e;a<t;a++){let o=Tn(a),l=Ht(qa(i,a),o);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${a}`:n[c]*l,d=(a>=0?0:o)+(a>=r[c]?0:r[c]),f=i==10?u:Ht(u,d);s.push(f),pr.set(f,d)}}return s}var yl={},Cf=[],Ya=[null,null],fr=Array.isArray,w0=Number.isInteger,qM=i=>i===void 0;function Xg(i){return typeof i=="string"}function Zh(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function YM(i){return i!=null&&typeof i=="object"}var ZM=Object.getPrototypeOf(Uint8Array),S0="__proto__";function Za(i,e=Zh){let t;if(fr(i)){let n=i.find(s=>s!=null);if(fr(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Za(i[s],e)}else t=i.slice()}else if(i instanceof ZM)t=i.slice();else if(e(i)){t={};for(let n in i)n!=S0&&(t[n]=Za(i[n],e))}else t=i;return t}function xn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=S0&&(Zh(i[s])?xn(i[s],Za(n[s])):i[s]=Za(n[s]))}return i}var KM=0,jM=1,JM=2;function QM(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let a=e[n];if(a>r){for(s=a-1;s>=0&&i[s]==null;)i[s--]=null;for(s=a+1;s<t&&i[s]==null;)i[r=s++]=null}}}function eE(i,e){if(iE(i)){let a=i[0].slice();for(let o=1;o<i.length;o++)a.push(...i[o].slice(1));return sE(a[0])||(a=nE(a)),a}let t=new Set;for(let a=0;a<i.length;a++){let l=i[a][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((a,o)=>a-o)],s=n[0].length,r=new Map;for(let a=0;a<s;a++)r.set(n[0][a],a);for(let a=0;a<i.length;a++){let o=i[a],l=o[0];for(let c=1;c<o.length;c++){let u=o[c],d=Array(s).fill(void 0),f=e?e[a][c]:jM,p=[];for(let g=0;g<u.length;g++){let _=u[g],m=r.get(l[g]);_===null?f!=KM&&(d[m]=_,f==JM&&p.push(m)):d[m]=_}QM(d,p,s),n.push(d)}}return n}var tE=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function nE(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,a)=>e[r]-e[a]);let s=[];for(let r=0;r<i.length;r++){let a=i[r],o=Array(t);for(let l=0;l<t;l++)o[l]=a[n[l]];s.push(o)}return s}function iE(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function sE(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ni(1,Mi((s-n+1)/e));for(let a=i[n],o=n+r;o<=s;o+=r){let l=i[o];if(l!=null){if(l<=a)return!1;a=l}}return!0}var M0=["January","February","March","April","May","June","July","August","September","October","November","December"],E0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function T0(i){return i.slice(0,3)}var rE=E0.map(T0),aE=M0.map(T0),oE={MMMM:M0,MMM:aE,WWWW:E0,WWW:rE};function pl(i){return(i<10?"0":"")+i}function lE(i){return(i<10?"00":i<100?"0":"")+i}var cE={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>pl(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>pl(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>pl(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>pl(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>pl(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>lE(i.getMilliseconds())};function Rf(i,e){e=e||oE;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?cE[s[1]]:s[0]);return r=>{let a="";for(let o=0;o<t.length;o++)a+=typeof t[o]=="string"?t[o]:t[o](r,e);return a}}var hE=new Intl.DateTimeFormat().resolvedOptions().timeZone;function uE(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==hE?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var A0=i=>i%1==0,$h=[1,2,2.5,5],dE=xl(10,-32,0,$h),C0=xl(10,0,32,$h),fE=C0.filter(A0),Hr=dE.concat(C0),Pf=`
`,R0="{YYYY}",qg=Pf+R0,P0="{M}/{D}",vl=Pf+P0,zh=vl+"/{YY}",L0="{aa}",pE="{h}:{mm}",$a=pE+L0,Yg=Pf+$a,Zg=":{ss}",kt=null;function I0(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,a=s*365,l=(i==1?xl(10,0,3,$h).filter(A0):xl(10,-3,0,$h)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,a,a*2,a*5,a*10,a*25,a*50,a*100]),c=[[a,R0,kt,kt,kt,kt,kt,kt,1],[s*28,"{MMM}",qg,kt,kt,kt,kt,kt,1],[s,P0,qg,kt,kt,kt,kt,kt,1],[n,"{h}"+L0,zh,kt,vl,kt,kt,kt,1],[t,$a,zh,kt,vl,kt,kt,kt,1],[e,Zg,zh+" "+$a,kt,vl+" "+$a,kt,Yg,kt,1],[i,Zg+".{fff}",zh+" "+$a,kt,vl+" "+$a,kt,Yg,kt,1]];function u(d){return(f,p,g,_,m,v)=>{let x=[],S=m>=a,y=m>=r&&m<a,T=d(g),M=Ht(T*i,3),b=cf(T.getFullYear(),S?0:T.getMonth(),y||S?1:T.getDate()),A=Ht(b*i,3);if(y||S){let O=y?m/r:0,N=S?m/a:0,P=M==A?M:Ht(cf(b.getFullYear()+N,b.getMonth()+O,1)*i,3),k=new Date(En(P/i)),B=k.getFullYear(),L=k.getMonth();for(let H=0;P<=_;H++){let Y=cf(B+N*H,L+O*H,1),$=Y-d(Ht(Y*i,3));P=Ht((+Y+$)*i,3),P<=_&&x.push(P)}}else{let O=m>=s?s:m,N=Mi(g)-Mi(M),P=A+N+Yh(M-A,O);x.push(P);let k=d(P),B=k.getHours()+k.getMinutes()/t+k.getSeconds()/n,L=m/n,H=f.axes[p]._space,Y=v/H;for(;P=Ht(P+m,i==1?0:3),!(P>_);)if(L>1){let $=Mi(Ht(B+L,6))%24,ee=d(P).getHours()-$;ee>1&&(ee=-1),P-=ee*n,B=(B+L)%24;let ne=x[x.length-1];Ht((P-ne)/m,3)*Y>=.7&&x.push(P)}else x.push(P)}return x}}return[l,c,u]}var[mE,gE,vE]=I0(1),[_E,yE,xE]=I0(.001);xl(2,-53,53,[1]);function Kg(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function jg(i,e){return(t,n,s,r,a)=>{let o=e.find(g=>a>=g[0])||e[e.length-1],l,c,u,d,f,p;return n.map(g=>{let _=i(g),m=_.getFullYear(),v=_.getMonth(),x=_.getDate(),S=_.getHours(),y=_.getMinutes(),T=_.getSeconds(),M=m!=l&&o[2]||v!=c&&o[3]||x!=u&&o[4]||S!=d&&o[5]||y!=f&&o[6]||T!=p&&o[7]||o[1];return l=m,c=v,u=x,d=S,f=y,p=T,M(_)})}}function bE(i,e){let t=Rf(e);return(n,s,r,a,o)=>s.map(l=>t(i(l)))}function cf(i,e,t){return new Date(i,e,t)}function Jg(i,e){return e(i)}var wE="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Qg(i,e){return(t,n,s,r)=>r==null?Sf:e(i(n))}function SE(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function ME(i,e){return i.series[e].fill(i,e)}var EE={show:!0,live:!0,isolate:!1,mount:WM,markers:{show:!0,width:2,stroke:SE,fill:ME,dash:"solid"},idx:null,idxs:null,values:[]};function TE(i,e){let t=i.cursor.points,n=ki(),s=t.size(i,e);Jt(n,ml,s),Jt(n,gl,s);let r=s/-2;Jt(n,"marginLeft",r),Jt(n,"marginTop",r);let a=t.width(i,e,s);return a&&Jt(n,"borderWidth",a),n}function AE(i,e){let t=i.series[e].points;return t._fill||t._stroke}function CE(i,e){let t=i.series[e].points;return t._stroke||t._fill}function RE(i,e){return i.series[e].points.size}var hf=[0,0];function PE(i,e,t){return hf[0]=e,hf[1]=t,hf}function Vh(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function uf(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var LE={show:!0,x:!0,y:!0,lock:!1,move:PE,points:{one:!1,show:TE,size:RE,width:0,stroke:CE,fill:AE},bind:{mousedown:Vh,mouseup:Vh,click:Vh,dblclick:Vh,mousemove:uf,mouseleave:uf,mouseenter:uf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},D0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Lf=xn({},D0,{filter:y0}),N0=xn({},Lf,{size:10}),k0=xn({},D0,{show:!1}),If='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',F0="bold "+If,U0=1.5,e0={show:!0,scale:"x",stroke:wf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:F0,side:2,grid:Lf,ticks:N0,border:k0,font:If,lineGap:U0,rotate:0},IE="Value",DE="Time",t0={show:!0,scale:"x",auto:!1,sorted:1,min:Gt,max:-Gt,idxs:[]};function NE(i,e,t,n,s){return e.map(r=>r==null?"":Af(r))}function kE(i,e,t,n,s,r,a){let o=[],l=pr.get(s)||0;t=a?t:Ht(Yh(t,s),l);for(let c=t;c<=n;c=Ht(c+s,l))o.push(Object.is(c,-0)?0:c);return o}function vf(i,e,t,n,s,r,a){let o=[],l=i.scales[i.axes[e].scale].log,c=l==10?Bs:g0,u=Mi(c(t));s=qa(l,u),l==10&&(s=Hr[Ji(s,Hr)]);let d=t,f=s*l;l==10&&(f=Hr[Ji(f,Hr)]);do o.push(d),d=d+s,l==10&&!pr.has(d)&&(d=Ht(d,pr.get(s))),d>=f&&(s=d,f=s*l,l==10&&(f=Hr[Ji(f,Hr)]));while(d<=n);return o}function FE(i,e,t,n,s,r,a){let l=i.scales[i.axes[e].scale].asinh,c=n>l?vf(i,e,ni(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?vf(i,e,ni(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var O0=/./,UE=/[12357]/,OE=/[125]/,n0=/1/,_f=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function BE(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=i.scales[a],l=i.valToPos,c=r._space,u=l(10,a),d=l(9,a)-u>=c?O0:l(7,a)-u>=c?UE:l(5,a)-u>=c?OE:n0;if(d==n0){let f=Tn(l(1,a)-u);if(f<c)return _f(e.slice().reverse(),o.distr,d,Fi(c/f)).reverse()}return _f(e,o.distr,d,1)}function zE(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=r._space,l=i.valToPos,c=Tn(l(1,a)-l(2,a));return c<o?_f(e.slice().reverse(),3,O0,Fi(o/c)).reverse():e}function VE(i,e,t,n){return n==null?Sf:e==null?"":Af(e)}var i0={show:!0,scale:"y",stroke:wf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:F0,side:3,grid:Lf,ticks:N0,border:k0,font:If,lineGap:U0,rotate:0};function GE(i,e){let t=3+(i||1)*2;return Ht(t*e,3)}function HE(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),a=i.valToPos(s[n[1]],t,!0),o=Tn(a-r),l=i.series[e],c=o/(l.points.space*It);return n[1]-n[0]<=c}var s0={scale:null,auto:!0,sorted:0,min:Gt,max:-Gt},B0=(i,e,t,n,s)=>s,r0={show:!0,auto:!0,sorted:0,gaps:B0,alpha:1,facets:[xn({},s0,{scale:"x"}),xn({},s0,{scale:"y"})]},a0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:B0,alpha:1,points:{show:HE,filter:null},values:null,min:Gt,max:-Gt,idxs:[],path:null,clip:null};function WE(i,e,t,n,s){return t/10}var z0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},$E=xn({},z0,{time:!1,ori:1}),o0={};function V0(i,e){let t=o0[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,a,o,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,a,o,l,c)}},i!=null&&(o0[i]=t)),t}var Ka=1,yf=2;function qr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,a=i.scales,o=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?a[s.facets[0].scale]:a[i.series[0].scale],d=n==2?a[s.facets[1].scale]:a[s.scale],f=o.left,p=o.top,g=o.width,_=o.height,m=i.valToPosH,v=i.valToPosV;return u.ori==0?t(s,l,c,u,d,m,v,f,p,g,_,jh,Ja,Qh,H0,$0):t(s,l,c,u,d,v,m,p,f,_,g,Jh,Qa,kf,W0,X0)}function Df(i,e){let t=0,n=0,s=Ct(i.bands,Cf);for(let r=0;r<s.length;r++){let a=s[r];a.series[0]==e?t=a.dir:a.series[1]==e&&(a.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function XE(i,e,t,n,s){let r=i.mode,a=i.series[e],o=r==2?a.facets[1].scale:a.scale,l=i.scales[o];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function zs(i,e,t,n,s,r){return qr(i,e,(a,o,l,c,u,d,f,p,g,_,m)=>{let v=a.pxRound,x=c.dir*(c.ori==0?1:-1),S=c.ori==0?Ja:Qa,y,T;x==1?(y=t,T=n):(y=n,T=t);let M=v(d(o[y],c,_,p)),b=v(f(l[y],u,m,g)),A=v(d(o[T],c,_,p)),O=v(f(r==1?u.max:u.min,u,m,g)),N=new Path2D(s);return S(N,A,O),S(N,M,O),S(N,M,b),N})}function Kh(i,e,t,n,s,r){let a=null;if(i.length>0){a=new Path2D;let o=e==0?Qh:kf,l=t;for(let d=0;d<i.length;d++){let f=i[d];if(f[1]>f[0]){let p=f[0]-l;p>0&&o(a,l,n,p,n+r),l=f[1]}}let c=t+s-l,u=10;c>0&&o(a,l,n-u/2,c,n+r+u)}return a}function qE(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Nf(i,e,t,n,s,r,a){let o=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let d=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let p=r(i[d]),g=f==d?p:r(i[f]),_=d-s;p=a<=0&&_>=0&&_<l?r(i[_]):p;let v=f+s;g=a>=0&&v>=0&&v<l?r(i[v]):g,g>=p&&o.push([p,g])}return o}function l0(i){return i==0?_0:i==1?En:e=>Gr(e,i)}function G0(i){let e=i==0?jh:Jh,t=i==0?(s,r,a,o,l,c)=>{s.arcTo(r,a,o,l,c)}:(s,r,a,o,l,c)=>{s.arcTo(a,r,l,o,c)},n=i==0?(s,r,a,o,l)=>{s.rect(r,a,o,l)}:(s,r,a,o,l)=>{s.rect(a,r,l,o)};return(s,r,a,o,l,c=0,u=0)=>{c==0&&u==0?n(s,r,a,o,l):(c=Qi(c,o/2,l/2),u=Qi(u,o/2,l/2),e(s,r+c,a),t(s,r+o,a,r+o,a+l,c),t(s,r+o,a+l,r,a+l,u),t(s,r,a+l,r,a,u),t(s,r,a,r+o,a,c),s.closePath())}}var jh=(i,e,t)=>{i.moveTo(e,t)},Jh=(i,e,t)=>{i.moveTo(t,e)},Ja=(i,e,t)=>{i.lineTo(e,t)},Qa=(i,e,t)=>{i.lineTo(t,e)},Qh=G0(0),kf=G0(1),H0=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},W0=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},$0=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(e,t,n,s,r,a)},X0=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(t,e,s,n,a,r)};function q0(i){return(e,t,n,s,r)=>qr(e,t,(a,o,l,c,u,d,f,p,g,_,m)=>{let{pxRound:v,points:x}=a,S,y;c.ori==0?(S=jh,y=H0):(S=Jh,y=W0);let T=Ht(x.width*It,3),M=(x.size-x.width)/2*It,b=Ht(M*2,3),A=new Path2D,O=new Path2D,{left:N,top:P,width:k,height:B}=e.bbox;Qh(O,N-b,P-b,k+b*2,B+b*2);let L=H=>{if(l[H]!=null){let Y=v(d(o[H],c,_,p)),$=v(f(l[H],u,m,g));S(A,Y+M,$),y(A,Y,$,M,0,Gh*2)}};if(r)r.forEach(L);else for(let H=n;H<=s;H++)L(H);return{stroke:T>0?A:null,fill:A,clip:O,flags:Ka|yf}})}function Y0(i){return(e,t,n,s,r,a)=>{n!=s&&(r!=n&&a!=n&&i(e,t,n),r!=s&&a!=s&&i(e,t,s),i(e,t,a))}}var YE=Y0(Ja),ZE=Y0(Qa);function Z0(i){let e=Ct(i?.alignGaps,0);return(t,n,s,r)=>qr(t,n,(a,o,l,c,u,d,f,p,g,_,m)=>{[s,r]=Xh(l,s,r);let v=a.pxRound,x=B=>v(d(B,c,_,p)),S=B=>v(f(B,u,m,g)),y,T;c.ori==0?(y=Ja,T=YE):(y=Qa,T=ZE);let M=c.dir*(c.ori==0?1:-1),b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ka},A=b.stroke,O=!1;if(r-s>=_*4){let B=de=>t.posToVal(de,c.key,!0),L=null,H=null,Y,$,ce,K=x(o[M==1?s:r]),ee=x(o[s]),ne=x(o[r]),ue=B(M==1?ee+1:ne-1);for(let de=M==1?s:r;de>=s&&de<=r;de+=M){let Q=o[de],ye=(M==1?Q<ue:Q>ue)?K:x(Q),Te=l[de];ye==K?Te!=null?($=Te,L==null?(y(A,ye,S($)),Y=L=H=$):$<L?L=$:$>H&&(H=$)):Te===null&&(O=!0):(L!=null&&T(A,K,S(L),S(H),S(Y),S($)),Te!=null?($=Te,y(A,ye,S($)),L=H=Y=$):(L=H=null,Te===null&&(O=!0)),K=ye,ue=B(K+M))}L!=null&&L!=H&&ce!=K&&T(A,K,S(L),S(H),S(Y),S($))}else for(let B=M==1?s:r;B>=s&&B<=r;B+=M){let L=l[B];L===null?O=!0:L!=null&&y(A,x(o[B]),S(L))}let[P,k]=Df(t,n);if(a.fill!=null||P!=0){let B=b.fill=new Path2D(A),L=a.fillTo(t,n,a.min,a.max,P),H=S(L),Y=x(o[s]),$=x(o[r]);M==-1&&([$,Y]=[Y,$]),y(B,$,H),y(B,Y,H)}if(!a.spanGaps){let B=[];O&&B.push(...Nf(o,l,s,r,M,x,e)),b.gaps=B=a.gaps(t,n,s,r,B),b.clip=Kh(B,c.ori,p,g,_,m)}return k!=0&&(b.band=k==2?[zs(t,n,s,r,A,-1),zs(t,n,s,r,A,1)]:zs(t,n,s,r,A,k)),b})}function KE(i){let e=Ct(i.align,1),t=Ct(i.ascDesc,!1),n=Ct(i.alignGaps,0),s=Ct(i.extend,!1);return(r,a,o,l)=>qr(r,a,(c,u,d,f,p,g,_,m,v,x,S)=>{[o,l]=Xh(d,o,l);let y=c.pxRound,{left:T,width:M}=r.bbox,b=ee=>y(g(ee,f,x,m)),A=ee=>y(_(ee,p,S,v)),O=f.ori==0?Ja:Qa,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ka},P=N.stroke,k=f.dir*(f.ori==0?1:-1),B=A(d[k==1?o:l]),L=b(u[k==1?o:l]),H=L,Y=L;s&&e==-1&&(Y=T,O(P,Y,B)),O(P,L,B);for(let ee=k==1?o:l;ee>=o&&ee<=l;ee+=k){let ne=d[ee];if(ne==null)continue;let ue=b(u[ee]),de=A(ne);e==1?O(P,ue,B):O(P,H,de),O(P,ue,de),B=de,H=ue}let $=H;s&&e==1&&($=T+M,O(P,$,B));let[ce,K]=Df(r,a);if(c.fill!=null||ce!=0){let ee=N.fill=new Path2D(P),ne=c.fillTo(r,a,c.min,c.max,ce),ue=A(ne);O(ee,$,ue),O(ee,Y,ue)}if(!c.spanGaps){let ee=[];ee.push(...Nf(u,d,o,l,k,b,n));let ne=c.width*It/2,ue=t||e==1?ne:-ne,de=t||e==-1?-ne:ne;ee.forEach(Q=>{Q[0]+=ue,Q[1]+=de}),N.gaps=ee=c.gaps(r,a,o,l,ee),N.clip=Kh(ee,f.ori,m,v,x,S)}return K!=0&&(N.band=K==2?[zs(r,a,o,l,P,-1),zs(r,a,o,l,P,1)]:zs(r,a,o,l,P,K)),N})}function c0(i,e,t,n,s,r,a=Gt){if(i.length>1){let o=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(o!=null){let u=Tn(i[l]-i[o]);u<c&&(c=u,a=Tn(t(i[l],n,s,r)-t(i[o],n,s,r)))}o=l}}return a}function jE(i){i=i||yl;let e=Ct(i.size,[.6,Gt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Et(s),a=1-e[0],o=Ct(e[1],Gt),l=Ct(e[2],1),c=Ct(i.disp,yl),u=Ct(i.each,p=>{}),{fill:d,stroke:f}=c;return(p,g,_,m)=>qr(p,g,(v,x,S,y,T,M,b,A,O,N,P)=>{let k=v.pxRound,B=t,L=n*It,H=o*It,Y=l*It,$,ce;y.ori==0?[$,ce]=r(p,g):[ce,$]=r(p,g);let K=y.dir*(y.ori==0?1:-1),ee=y.ori==0?Qh:kf,ne=y.ori==0?u:(Ne,tt,ht,Ce,Vt,Xe,je)=>{u(Ne,tt,ht,Vt,Ce,je,Xe)},ue=Ct(p.bands,Cf).find(Ne=>Ne.series[0]==g),de=ue!=null?ue.dir:0,Q=v.fillTo(p,g,v.min,v.max,de),ge=k(b(Q,T,P,O)),ye,Te,be,Ye=N,he=k(v.width*It),Ie=!1,rt=null,dt=null,qe=null,Ft=null;d!=null&&(he==0||f!=null)&&(Ie=!0,rt=d.values(p,g,_,m),dt=new Map,new Set(rt).forEach(Ne=>{Ne!=null&&dt.set(Ne,new Path2D)}),he>0&&(qe=f.values(p,g,_,m),Ft=new Map,new Set(qe).forEach(Ne=>{Ne!=null&&Ft.set(Ne,new Path2D)})));let{x0:Rt,size:Wt}=c;if(Rt!=null&&Wt!=null){B=1,x=Rt.values(p,g,_,m),Rt.unit==2&&(x=x.map(ht=>p.posToVal(A+ht*N,y.key,!0)));let Ne=Wt.values(p,g,_,m);Wt.unit==2?Te=Ne[0]*N:Te=M(Ne[0],y,N,A)-M(0,y,N,A),Ye=c0(x,S,M,y,N,A,Ye),be=Ye-Te+L}else Ye=c0(x,S,M,y,N,A,Ye),be=Ye*a+L,Te=Ye-be;be<1&&(be=0),he>=Te/2&&(he=0),be<5&&(k=_0);let Tt=be>0,Dt=Ye-be-(Tt?he:0);Te=k(gf(Dt,Y,H)),ye=(B==0?Te/2:B==K?0:Te)-B*K*((B==0?L/2:0)+(Tt?he/2:0));let ut={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},nn=Ie?null:new Path2D,rn=null;if(ue!=null)rn=p.data[ue.series[1]];else{let{y0:Ne,y1:tt}=c;Ne!=null&&tt!=null&&(S=tt.values(p,g,_,m),rn=Ne.values(p,g,_,m))}let pn=$*Te,V=ce*Te;for(let Ne=K==1?_:m;Ne>=_&&Ne<=m;Ne+=K){let tt=S[Ne];if(tt==null)continue;if(rn!=null){let q=rn[Ne]??0;if(tt-q==0)continue;ge=b(q,T,P,O)}let ht=y.distr!=2||c!=null?x[Ne]:Ne,Ce=M(ht,y,N,A),Vt=b(Ct(tt,Q),T,P,O),Xe=k(Ce-ye),je=k(ni(Vt,ge)),I=k(Qi(Vt,ge)),E=je-I;if(tt!=null){let q=tt<0?V:pn,pe=tt<0?pn:V;Ie?(he>0&&qe[Ne]!=null&&ee(Ft.get(qe[Ne]),Xe,I+Mi(he/2),Te,ni(0,E-he),q,pe),rt[Ne]!=null&&ee(dt.get(rt[Ne]),Xe,I+Mi(he/2),Te,ni(0,E-he),q,pe)):ee(nn,Xe,I+Mi(he/2),Te,ni(0,E-he),q,pe),ne(p,g,Ne,Xe-he/2,I,Te+he,E)}}return he>0?ut.stroke=Ie?Ft:nn:Ie||(ut._fill=v.width==0?v._fill:v._stroke??v._fill,ut.width=0),ut.fill=Ie?dt:nn,ut})}function JE(i,e){let t=Ct(e?.alignGaps,0);return(n,s,r,a)=>qr(n,s,(o,l,c,u,d,f,p,g,_,m,v)=>{[r,a]=Xh(c,r,a);let x=o.pxRound,S=$=>x(f($,u,m,g)),y=$=>x(p($,d,v,_)),T,M,b;u.ori==0?(T=jh,b=Ja,M=$0):(T=Jh,b=Qa,M=X0);let A=u.dir*(u.ori==0?1:-1),O=S(l[A==1?r:a]),N=O,P=[],k=[];for(let $=A==1?r:a;$>=r&&$<=a;$+=A)if(c[$]!=null){let K=l[$],ee=S(K);P.push(N=ee),k.push(y(c[$]))}let B={stroke:i(P,k,T,b,M,x),fill:null,clip:null,band:null,gaps:null,flags:Ka},L=B.stroke,[H,Y]=Df(n,s);if(o.fill!=null||H!=0){let $=B.fill=new Path2D(L),ce=o.fillTo(n,s,o.min,o.max,H),K=y(ce);b($,N,K),b($,O,K)}if(!o.spanGaps){let $=[];$.push(...Nf(l,c,r,a,A,S,t)),B.gaps=$=o.gaps(n,s,r,a,$),B.clip=Kh($,u.ori,g,_,m,v)}return Y!=0&&(B.band=Y==2?[zs(n,s,r,a,L,-1),zs(n,s,r,a,L,1)]:zs(n,s,r,a,L,Y)),B})}function QE(i){return JE(e1,i)}function e1(i,e,t,n,s,r){let a=i.length;if(a<2)return null;let o=new Path2D;if(t(o,i[0],e[0]),a==2)n(o,i[1],e[1]);else{let l=Array(a),c=Array(a-1),u=Array(a-1),d=Array(a-1);for(let f=0;f<a-1;f++)u[f]=e[f+1]-e[f],d[f]=i[f+1]-i[f],c[f]=u[f]/d[f];l[0]=c[0];for(let f=1;f<a-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(d[f-1]+d[f])/((2*d[f]+d[f-1])/c[f-1]+(d[f]+2*d[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[a-1]=c[a-2];for(let f=0;f<a-1;f++)s(o,i[f]+d[f]/3,e[f]+l[f]*d[f]/3,i[f+1]-d[f]/3,e[f+1]-l[f+1]*d[f]/3,i[f+1],e[f+1])}return o}var xf=new Set;function h0(){for(let i of xf)i.syncRect(!0)}ja&&($r(NM,Xa,h0),$r(kM,Xa,h0,!0),$r(Hh,Xa,()=>{Nn.pxRatio=It}));var t1=Z0(),n1=q0();function u0(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,a)=>bf(r,a,e,t))}function i1(i,e){return i.map((t,n)=>n==0?{}:xn({},e,t))}function bf(i,e,t,n){return xn({},e==0?t:n,i)}function K0(i,e,t){return e==null?Ya:[e,t]}var s1=K0;function r1(i,e,t){return e==null?Ya:Wh(e,t,Tf,!0)}function j0(i,e,t,n){return e==null?Ya:qh(e,t,i.scales[n].log,!1)}var a1=j0;function J0(i,e,t,n){return e==null?Ya:Ef(e,t,i.scales[n].log,!1)}var o1=J0;function l1(i,e,t,n,s){let r=ni(Hg(i),Hg(e)),a=e-i,o=Ji(s/n*a,t);do{let l=t[o],c=n*l/a;if(c>=s&&r+(l<5?pr.get(l):0)<=17)return[l,c]}while(++o<t.length);return[0,0]}function d0(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=En((t=+s)*It))+"px"),[i,e,t]}function c1(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ht(e[2]*It,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Nn(i,e,t){let n={mode:Ct(i.mode,1)},s=n.mode;function r(w,C,D,U){let X=C.valToPct(w);return U+D*(C.dir==-1?1-X:X)}function a(w,C,D,U){let X=C.valToPct(w);return U+D*(C.dir==-1?X:1-X)}function o(w,C,D,U){return C.ori==0?r(w,C,D,U):a(w,C,D,U)}n.valToPosH=r,n.valToPosV=a;let l=!1;n.status=0;let c=n.root=ki(gM);if(i.id!=null&&(c.id=i.id),Si(c,i.class),i.title){let w=ki(yM,c);w.textContent=i.title}let u=ji("canvas"),d=n.ctx=u.getContext("2d"),f=ki(xM,c);$r("click",f,w=>{w.target===g&&(Yt!=sa||Qt!=ra)&&kn.click(n,w)},!0);let p=n.under=ki(bM,f);f.appendChild(u);let g=n.over=ki(wM,f);i=Za(i);let _=+Ct(i.pxAlign,1),m=l0(_);(i.plugins||[]).forEach(w=>{w.opts&&(i=w.opts(n,i)||i)});let v=i.ms||.001,x=n.series=s==1?u0(i.series||[],t0,a0,!1):i1(i.series||[null],r0),S=n.axes=u0(i.axes||[],e0,i0,!0),y=n.scales={},T=n.bands=i.bands||[];T.forEach(w=>{w.fill=Et(w.fill||null),w.dir=Ct(w.dir,-1)});let M=s==2?x[1].facets[0].scale:x[0].scale,b={axes:ws,series:yt},A=(i.drawOrder||["axes","series"]).map(w=>b[w]);function O(w){let C=w.distr==3?D=>Bs(D>0?D:w.clamp(n,D,w.min,w.max,w.key)):w.distr==4?D=>lf(D,w.asinh):w.distr==100?D=>w.fwd(D):D=>D;return D=>{let U=C(D),{_min:X,_max:J}=w,le=J-X;return(U-X)/le}}function N(w){let C=y[w];if(C==null){let D=(i.scales||yl)[w]||yl;if(D.from!=null){N(D.from);let U=xn({},y[D.from],D,{key:w});U.valToPct=O(U),y[w]=U}else{C=y[w]=xn({},w==M?z0:$E,D),C.key=w;let U=C.time,X=C.range,J=fr(X);if((w!=M||s==2&&!U)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?zg:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?zg:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&Zh(X))){let le=X;X=(ve,Ee,Oe)=>Ee==null?Ya:Wh(Ee,Oe,le)}C.range=Et(X||(U?s1:w==M?C.distr==3?a1:C.distr==4?o1:K0:C.distr==3?j0:C.distr==4?J0:r1)),C.auto=Et(J?!1:C.auto),C.clamp=Et(C.clamp||WE),C._min=C._max=null,C.valToPct=O(C)}}}N("x"),N("y"),s==1&&x.forEach(w=>{N(w.scale)}),S.forEach(w=>{N(w.scale)});for(let w in i.scales)N(w);let P=y[M],k=P.distr,B,L;P.ori==0?(Si(c,vM),B=r,L=a):(Si(c,_M),B=a,L=r);let H={};for(let w in y){let C=y[w];(C.min!=null||C.max!=null)&&(H[w]={min:C.min,max:C.max},C.min=C.max=null)}let Y=i.tzDate||(w=>new Date(En(w/v))),$=i.fmtDate||Rf,ce=v==1?vE(Y):xE(Y),K=jg(Y,Kg(v==1?gE:yE,$)),ee=Qg(Y,Jg(wE,$)),ne=[],ue=n.legend=xn({},EE,i.legend),de=n.cursor=xn({},LE,{drag:{y:s==2}},i.cursor),Q=ue.show,ge=de.show,ye=ue.markers;ue.idxs=ne,ye.width=Et(ye.width),ye.dash=Et(ye.dash),ye.stroke=Et(ye.stroke),ye.fill=Et(ye.fill);let Te,be,Ye,he=[],Ie=[],rt,dt=!1,qe={};if(ue.live){let w=x[1]?x[1].values:null;dt=w!=null,rt=dt?w(n,1,0):{_:0};for(let C in rt)qe[C]=Sf}if(Q)if(Te=ji("table",CM,c),Ye=ji("tbody",null,Te),ue.mount(n,Te),dt){be=ji("thead",null,Te,Ye);let w=ji("tr",null,be);ji("th",null,w);for(var Ft in rt)ji("th",Ag,w).textContent=Ft}else Si(Te,PM),ue.live&&Si(Te,RM);let Rt={show:!0},Wt={show:!1};function Tt(w,C){if(C==0&&(dt||!ue.live||s==2))return Ya;let D=[],U=ji("tr",LM,Ye,Ye.childNodes[C]);Si(U,w.class),w.show||Si(U,Wr);let X=ji("th",null,U);if(ye.show){let ve=ki(IM,X);if(C>0){let Ee=ye.width(n,C);Ee&&(ve.style.border=Ee+"px "+ye.dash(n,C)+" "+ye.stroke(n,C)),ve.style.background=ye.fill(n,C)}}let J=ki(Ag,X);w.label instanceof HTMLElement?J.appendChild(w.label):J.textContent=w.label,C>0&&(ye.show||(J.style.color=w.width>0?ye.stroke(n,C):ye.fill(n,C)),ut("click",X,ve=>{if(de._lock)return;it(ve);let Ee=x.indexOf(w);if((ve.ctrlKey||ve.metaKey)!=ue.isolate){let Oe=x.some((Be,Ve)=>Ve>0&&Ve!=Ee&&Be.show);x.forEach((Be,Ve)=>{Ve>0&&ss(Ve,Oe?Ve==Ee?Rt:Wt:Rt,!0,_n.setSeries)})}else ss(Ee,{show:!w.show},!0,_n.setSeries)},!1),st&&ut(Lg,X,ve=>{de._lock||(it(ve),ss(x.indexOf(w),oa,!0,_n.setSeries))},!1));for(var le in rt){let ve=ji("td",DM,U);ve.textContent="--",D.push(ve)}return[U,D]}let Dt=new Map;function ut(w,C,D,U=!0){let X=Dt.get(C)||{},J=de.bind[w](n,C,D,U);J&&($r(w,C,X[w]=J),Dt.set(C,X))}function nn(w,C,D){let U=Dt.get(C)||{};for(let X in U)(w==null||X==w)&&(mf(X,C,U[X]),delete U[X]);w==null&&Dt.delete(C)}let rn=0,pn=0,V=0,Ne=0,tt=0,ht=0,Ce=tt,Vt=ht,Xe=V,je=Ne,I=0,E=0,q=0,pe=0;n.bbox={};let oe=!1,Se=!1,Me=!1,ie=!1,re=!1,_e=!1;function z(w,C,D){(D||w!=n.width||C!=n.height)&&ae(w,C),pt(!1),Me=!0,Se=!0,On()}function ae(w,C){n.width=rn=V=w,n.height=pn=Ne=C,tt=ht=0,Ae(),Ze();let D=n.bbox;I=D.left=Gr(tt*It,.5),E=D.top=Gr(ht*It,.5),q=D.width=Gr(V*It,.5),pe=D.height=Gr(Ne*It,.5)}let se=3;function Re(){let w=!1,C=0;for(;!w;){C++;let D=ta(C),U=is(C);w=C==se||D&&U,w||(ae(n.width,n.height),Se=!0)}}function we({width:w,height:C}){z(w,C)}n.setSize=we;function Ae(){let w=!1,C=!1,D=!1,U=!1;S.forEach((X,J)=>{if(X.show&&X._show){let{side:le,_size:ve}=X,Ee=le%2,Oe=X.label!=null?X.labelSize:0,Be=ve+Oe;Be>0&&(Ee?(V-=Be,le==3?(tt+=Be,U=!0):D=!0):(Ne-=Be,le==0?(ht+=Be,w=!0):C=!0))}}),ts[0]=w,ts[1]=D,ts[2]=C,ts[3]=U,V-=Oi[1]+Oi[3],tt+=Oi[3],Ne-=Oi[2]+Oi[0],ht+=Oi[0]}function Ze(){let w=tt+V,C=ht+Ne,D=tt,U=ht;function X(J,le){switch(J){case 1:return w+=le,w-le;case 2:return C+=le,C-le;case 3:return D-=le,D+le;case 0:return U-=le,U+le}}S.forEach((J,le)=>{if(J.show&&J._show){let ve=J.side;J._pos=X(ve,J._size),J.label!=null&&(J._lpos=X(ve,J.labelSize))}})}if(de.dataIdx==null){let w=de.hover,C=w.skip=new Set(w.skip??[]);C.add(void 0);let D=w.prox=Et(w.prox),U=w.bias??=0;de.dataIdx=(X,J,le,ve)=>{if(J==0)return le;let Ee=le,Oe=D(X,J,le,ve)??Gt,Be=Oe>=0&&Oe<Gt,Ve=P.ori==0?V:Ne,ct=de.left,Pt=e[0],At=e[J];if(C.has(At[le])){Ee=null;let bt=null,nt=null,Ke;if(U==0||U==-1)for(Ke=le;bt==null&&Ke-- >0;)C.has(At[Ke])||(bt=Ke);if(U==0||U==1)for(Ke=le;nt==null&&Ke++<At.length;)C.has(At[Ke])||(nt=Ke);if(bt!=null||nt!=null)if(Be){let Kt=bt==null?-1/0:B(Pt[bt],P,Ve,0),ln=nt==null?1/0:B(Pt[nt],P,Ve,0),Pn=ct-Kt,zt=ln-ct;Pn<=zt?Pn<=Oe&&(Ee=bt):zt<=Oe&&(Ee=nt)}else Ee=nt==null?bt:bt==null?nt:le-bt<=nt-le?bt:nt}else Be&&Tn(ct-B(Pt[le],P,Ve,0))>Oe&&(Ee=null);return Ee}}let it=w=>{de.event=w};de.idxs=ne,de._lock=!1;let fe=de.points;fe.show=Et(fe.show),fe.size=Et(fe.size),fe.stroke=Et(fe.stroke),fe.width=Et(fe.width),fe.fill=Et(fe.fill);let He=n.focus=xn({},i.focus||{alpha:.3},de.focus),st=He.prox>=0,De=st&&fe.one,ft=[],qt=[],Xn=[];function oo(w,C){let D=fe.show(n,C);if(D instanceof HTMLElement)return Si(D,AM),Si(D,w.class),gs(D,-10,-10,V,Ne),g.insertBefore(D,ft[C]),D}function Jr(w,C){if(s==1||C>0){let D=s==1&&y[w.scale].time,U=w.value;w.value=D?Xg(U)?Qg(Y,Jg(U,$)):U||ee:U||VE,w.label=w.label||(D?DE:IE)}if(De||C>0){w.width=w.width==null?1:w.width,w.paths=w.paths||t1||$M,w.fillTo=Et(w.fillTo||XE),w.pxAlign=+Ct(w.pxAlign,_),w.pxRound=l0(w.pxAlign),w.stroke=Et(w.stroke||null),w.fill=Et(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let D=GE(ni(1,w.width),1),U=w.points=xn({},{size:D,width:ni(1,D*.2),stroke:w.stroke,space:D*2,paths:n1,_stroke:null,_fill:null},w.points);U.show=Et(U.show),U.filter=Et(U.filter),U.fill=Et(U.fill),U.stroke=Et(U.stroke),U.paths=Et(U.paths),U.pxAlign=w.pxAlign}if(Q){let D=Tt(w,C);he.splice(C,0,D[0]),Ie.splice(C,0,D[1]),ue.values.push(null)}if(ge){ne.splice(C,0,null);let D=null;De?C==0&&(D=oo(w,C)):C>0&&(D=oo(w,C)),ft.splice(C,0,D),qt.splice(C,0,0),Xn.splice(C,0,0)}Rn("addSeries",C)}function vu(w,C){C=C??x.length,w=s==1?bf(w,C,t0,a0):bf(w,C,{},r0),x.splice(C,0,w),Jr(x[C],C)}n.addSeries=vu;function Pl(w){if(x.splice(w,1),Q){ue.values.splice(w,1),Ie.splice(w,1);let C=he.splice(w,1)[0];nn(null,C.firstChild),C.remove()}ge&&(ne.splice(w,1),ft.splice(w,1)[0].remove(),qt.splice(w,1),Xn.splice(w,1)),Rn("delSeries",w)}n.delSeries=Pl;let ts=[!1,!1,!1,!1];function ys(w,C){if(w._show=w.show,w.show){let D=w.side%2,U=y[w.scale];U==null&&(w.scale=D?x[1].scale:M,U=y[w.scale]);let X=U.time;w.size=Et(w.size),w.space=Et(w.space),w.rotate=Et(w.rotate),fr(w.incrs)&&w.incrs.forEach(le=>{!pr.has(le)&&pr.set(le,b0(le))}),w.incrs=Et(w.incrs||(U.distr==2?fE:X?v==1?mE:_E:Hr)),w.splits=Et(w.splits||(X&&U.distr==1?ce:U.distr==3?vf:U.distr==4?FE:kE)),w.stroke=Et(w.stroke),w.grid.stroke=Et(w.grid.stroke),w.ticks.stroke=Et(w.ticks.stroke),w.border.stroke=Et(w.border.stroke);let J=w.values;w.values=fr(J)&&!fr(J[0])?Et(J):X?fr(J)?jg(Y,Kg(J,$)):Xg(J)?bE(Y,J):J||K:J||NE,w.filter=Et(w.filter||(U.distr>=3&&U.log==10?BE:U.distr==3&&U.log==2?zE:y0)),w.font=d0(w.font),w.labelFont=d0(w.labelFont),w._size=w.size(n,null,C,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(ts[C]=!0,w._el=ki(SM,f))}}function xs(w,C,D,U){let[X,J,le,ve]=D,Ee=C%2,Oe=0;return Ee==0&&(ve||J)&&(Oe=C==0&&!X||C==2&&!le?En(e0.size/3):0),Ee==1&&(X||le)&&(Oe=C==1&&!J||C==3&&!ve?En(i0.size/2):0),Oe}let lo=n.padding=(i.padding||[xs,xs,xs,xs]).map(w=>Et(Ct(w,xs))),Oi=n._padding=lo.map((w,C)=>w(n,C,ts,0)),an,un=null,dn=null,ns=s==1?x[0].idxs:null,ci=null,$s=!1;function co(w,C){if(e=w??[],n.data=n._data=e,s==2){an=0;for(let D=1;D<x.length;D++)an+=e[D][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ci=e[0],an=ci.length;let D=e;if(k==2){D=e.slice();let U=D[0]=Array(an);for(let X=0;X<an;X++)U[X]=X}n._data=e=D}if(pt(!0),Rn("setData"),k==2&&(Me=!0),C!==!1){let D=P;D.auto(n,$s)?ho():Ys(M,D.min,D.max),ie=ie||de.left>=0,_e=!0,On()}}n.setData=co;function ho(){$s=!0;let w,C;s==1&&(an>0?(un=ns[0]=0,dn=ns[1]=an-1,w=e[0][un],C=e[0][dn],k==2?(w=un,C=dn):w==C&&(k==3?[w,C]=qh(w,w,P.log,!1):k==4?[w,C]=Ef(w,w,P.log,!1):P.time?C=w+En(86400/v):[w,C]=Wh(w,C,Tf,!0))):(un=ns[0]=w=null,dn=ns[1]=C=null)),Ys(M,w,C)}let Qr,Xs,ea,R,W,te,Z,j,Pe,ke;function Le(w,C,D,U,X,J){w??=Rg,D??=Cf,U??="butt",X??=Rg,J??="round",w!=Qr&&(d.strokeStyle=Qr=w),X!=Xs&&(d.fillStyle=Xs=X),C!=ea&&(d.lineWidth=ea=C),J!=W&&(d.lineJoin=W=J),U!=te&&(d.lineCap=te=U),D!=R&&d.setLineDash(R=D)}function Fe(w,C,D,U){C!=Xs&&(d.fillStyle=Xs=C),w!=Z&&(d.font=Z=w),D!=j&&(d.textAlign=j=D),U!=Pe&&(d.textBaseline=Pe=U)}function $e(w,C,D,U,X=0){if(U.length>0&&w.auto(n,$s)&&(C==null||C.min==null)){let J=Ct(un,0),le=Ct(dn,U.length-1),ve=D.min==null?BM(U,J,le,X,w.distr==3):[D.min,D.max];w.min=Qi(w.min,D.min=ve[0]),w.max=ni(w.max,D.max=ve[1])}}let at={min:null,max:null};function _t(){for(let U in y){let X=y[U];H[U]==null&&(X.min==null||H[M]!=null&&X.auto(n,$s))&&(H[U]=at)}for(let U in y){let X=y[U];H[U]==null&&X.from!=null&&H[X.from]!=null&&(H[U]=at)}H[M]!=null&&pt(!0);let w={};for(let U in H){let X=H[U];if(X!=null){let J=w[U]=Za(y[U],YM);if(X.min!=null)xn(J,X);else if(U!=M||s==2)if(an==0&&J.from==null){let le=J.range(n,null,null,U);J.min=le[0],J.max=le[1]}else J.min=Gt,J.max=-Gt}}if(an>0){x.forEach((U,X)=>{if(s==1){let J=U.scale,le=H[J];if(le==null)return;let ve=w[J];if(X==0){let Ee=ve.range(n,ve.min,ve.max,J);ve.min=Ee[0],ve.max=Ee[1],un=Ji(ve.min,e[0]),dn=Ji(ve.max,e[0]),dn-un>1&&(e[0][un]<ve.min&&un++,e[0][dn]>ve.max&&dn--),U.min=ci[un],U.max=ci[dn]}else U.show&&U.auto&&$e(ve,le,U,e[X],U.sorted);U.idxs[0]=un,U.idxs[1]=dn}else if(X>0&&U.show&&U.auto){let[J,le]=U.facets,ve=J.scale,Ee=le.scale,[Oe,Be]=e[X],Ve=w[ve],ct=w[Ee];Ve!=null&&$e(Ve,H[ve],J,Oe,J.sorted),ct!=null&&$e(ct,H[Ee],le,Be,le.sorted),U.min=le.min,U.max=le.max}});for(let U in w){let X=w[U],J=H[U];if(X.from==null&&(J==null||J.min==null)){let le=X.range(n,X.min==Gt?null:X.min,X.max==-Gt?null:X.max,U);X.min=le[0],X.max=le[1]}}}for(let U in w){let X=w[U];if(X.from!=null){let J=w[X.from];if(J.min==null)X.min=X.max=null;else{let le=X.range(n,J.min,J.max,U);X.min=le[0],X.max=le[1]}}}let C={},D=!1;for(let U in w){let X=w[U],J=y[U];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let le=J.distr;J._min=le==3?Bs(J.min):le==4?lf(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?Bs(J.max):le==4?lf(J.max,J.asinh):le==100?J.fwd(J.max):J.max,C[U]=D=!0}}if(D){x.forEach((U,X)=>{s==2?X>0&&C.y&&(U._paths=null):C[U.scale]&&(U._paths=null)});for(let U in C)Me=!0,Rn("setScale",U);ge&&de.left>=0&&(ie=_e=!0)}for(let U in H)H[U]=null}function We(w){let C=gf(un-1,0,an-1),D=gf(dn+1,0,an-1);for(;w[C]==null&&C>0;)C--;for(;w[D]==null&&D<an-1;)D++;return[C,D]}function yt(){if(an>0){let w=x.some(C=>C._focus)&&ke!=He.alpha;w&&(d.globalAlpha=ke=He.alpha),x.forEach((C,D)=>{if(D>0&&C.show&&(sn(D,!1),sn(D,!0),C._paths==null)){let U=ke;ke!=C.alpha&&(d.globalAlpha=ke=C.alpha);let X=s==2?[0,e[D][0].length-1]:We(e[D]);C._paths=C.paths(n,D,X[0],X[1]),ke!=U&&(d.globalAlpha=ke=U)}}),x.forEach((C,D)=>{if(D>0&&C.show){let U=ke;ke!=C.alpha&&(d.globalAlpha=ke=C.alpha),C._paths!=null&&Ut(D,!1);{let X=C._paths!=null?C._paths.gaps:null,J=C.points.show(n,D,un,dn,X),le=C.points.filter(n,D,J,X);(J||le)&&(C.points._paths=C.points.paths(n,D,un,dn,le),Ut(D,!0))}ke!=U&&(d.globalAlpha=ke=U),Rn("drawSeries",D)}}),w&&(d.globalAlpha=ke=1)}}function sn(w,C){let D=C?x[w].points:x[w];D._stroke=D.stroke(n,w),D._fill=D.fill(n,w)}function Ut(w,C){let D=C?x[w].points:x[w],{stroke:U,fill:X,clip:J,flags:le,_stroke:ve=D._stroke,_fill:Ee=D._fill,_width:Oe=D.width}=D._paths;Oe=Ht(Oe*It,3);let Be=null,Ve=Oe%2/2;C&&Ee==null&&(Ee=Oe>0?"#fff":ve);let ct=D.pxAlign==1&&Ve>0;if(ct&&d.translate(Ve,Ve),!C){let Pt=I-Oe/2,At=E-Oe/2,bt=q+Oe,nt=pe+Oe;Be=new Path2D,Be.rect(Pt,At,bt,nt)}C?ze(ve,Oe,D.dash,D.cap,Ee,U,X,le,J):Ot(w,ve,Oe,D.dash,D.cap,Ee,U,X,le,Be,J),ct&&d.translate(-Ve,-Ve)}function Ot(w,C,D,U,X,J,le,ve,Ee,Oe,Be){let Ve=!1;Ee!=0&&T.forEach((ct,Pt)=>{if(ct.series[0]==w){let At=x[ct.series[1]],bt=e[ct.series[1]],nt=(At._paths||yl).band;fr(nt)&&(nt=ct.dir==1?nt[0]:nt[1]);let Ke,Kt=null;At.show&&nt&&VM(bt,un,dn)?(Kt=ct.fill(n,Pt)||J,Ke=At._paths.clip):nt=null,ze(C,D,U,X,Kt,le,ve,Ee,Oe,Be,Ke,nt),Ve=!0}}),Ve||ze(C,D,U,X,J,le,ve,Ee,Oe,Be)}let bn=Ka|yf;function ze(w,C,D,U,X,J,le,ve,Ee,Oe,Be,Ve){Le(w,C,D,U,X),(Ee||Oe||Ve)&&(d.save(),Ee&&d.clip(Ee),Oe&&d.clip(Oe)),Ve?(ve&bn)==bn?(d.clip(Ve),Be&&d.clip(Be),wt(X,le),mn(w,J,C)):ve&yf?(wt(X,le),d.clip(Ve),mn(w,J,C)):ve&Ka&&(d.save(),d.clip(Ve),Be&&d.clip(Be),wt(X,le),d.restore(),mn(w,J,C)):(wt(X,le),mn(w,J,C)),(Ee||Oe||Ve)&&d.restore()}function mn(w,C,D){D>0&&(C instanceof Map?C.forEach((U,X)=>{d.strokeStyle=Qr=X,d.stroke(U)}):C!=null&&w&&d.stroke(C))}function wt(w,C){C instanceof Map?C.forEach((D,U)=>{d.fillStyle=Xs=U,d.fill(D)}):C!=null&&w&&d.fill(C)}function bs(w,C,D,U){let X=S[w],J;if(U<=0)J=[0,0];else{let le=X._space=X.space(n,w,C,D,U),ve=X._incrs=X.incrs(n,w,C,D,U,le);J=l1(C,D,ve,U,le)}return X._found=J}function gn(w,C,D,U,X,J,le,ve,Ee,Oe){let Be=le%2/2;_==1&&d.translate(Be,Be),Le(ve,le,Ee,Oe,ve),d.beginPath();let Ve,ct,Pt,At,bt=X+(U==0||U==3?-J:J);D==0?(ct=X,At=bt):(Ve=X,Pt=bt);for(let nt=0;nt<w.length;nt++)C[nt]!=null&&(D==0?Ve=Pt=w[nt]:ct=At=w[nt],d.moveTo(Ve,ct),d.lineTo(Pt,At));d.stroke(),_==1&&d.translate(-Be,-Be)}function ta(w){let C=!0;return S.forEach((D,U)=>{if(!D.show)return;let X=y[D.scale];if(X.min==null){D._show&&(C=!1,D._show=!1,pt(!1));return}else D._show||(C=!1,D._show=!0,pt(!1));let J=D.side,le=J%2,{min:ve,max:Ee}=X,[Oe,Be]=bs(U,ve,Ee,le==0?V:Ne);if(Be==0)return;let Ve=X.distr==2,ct=D._splits=D.splits(n,U,ve,Ee,Oe,Be,Ve),Pt=X.distr==2?ct.map(Ke=>ci[Ke]):ct,At=X.distr==2?ci[ct[1]]-ci[ct[0]]:Oe,bt=D._values=D.values(n,D.filter(n,Pt,U,Be,At),U,Be,At);D._rotate=J==2?D.rotate(n,bt,U,Be):0;let nt=D._size;D._size=Fi(D.size(n,bt,U,w)),nt!=null&&D._size!=nt&&(C=!1)}),C}function is(w){let C=!0;return lo.forEach((D,U)=>{let X=D(n,U,ts,w);X!=Oi[U]&&(C=!1),Oi[U]=X}),C}function ws(){for(let w=0;w<S.length;w++){let C=S[w];if(!C.show||!C._show)continue;let D=C.side,U=D%2,X,J,le=C.stroke(n,w),ve=D==0||D==3?-1:1,[Ee,Oe]=C._found;if(C.label!=null){let Zn=C.labelGap*ve,di=En((C._lpos+Zn)*It);Fe(C.labelFont[0],le,"center",D==2?"top":Cg),d.save(),U==1?(X=J=0,d.translate(di,En(E+pe/2)),d.rotate((D==3?-Gh:Gh)/2)):(X=En(I+q/2),J=di);let Mr=v0(C.label)?C.label(n,w,Ee,Oe):C.label;d.fillText(Mr,X,J),d.restore()}if(Oe==0)continue;let Be=y[C.scale],Ve=U==0?q:pe,ct=U==0?I:E,Pt=C._splits,At=Be.distr==2?Pt.map(Zn=>ci[Zn]):Pt,bt=Be.distr==2?ci[Pt[1]]-ci[Pt[0]]:Ee,nt=C.ticks,Ke=C.border,Kt=nt.show?nt.size:0,ln=En(Kt*It),Pn=En((C.alignTo==2?C._size-Kt-C.gap:C.gap)*It),zt=C._rotate*-Gh/180,cn=m(C._pos*It),hi=(ln+Pn)*ve,Yn=cn+hi;J=U==0?Yn:0,X=U==1?Yn:0;let Ai=C.font[0],Bi=C.align==1?Wa:C.align==2?rf:zt>0?Wa:zt<0?rf:U==0?"center":D==3?rf:Wa,as=zt||U==1?"middle":D==2?"top":Cg;Fe(Ai,le,Bi,as);let ui=C.font[1]*C.lineGap,Ci=Pt.map(Zn=>m(o(Zn,Be,Ve,ct))),zi=C._values;for(let Zn=0;Zn<zi.length;Zn++){let di=zi[Zn];if(di!=null){U==0?X=Ci[Zn]:J=Ci[Zn],di=""+di;let Mr=di.indexOf(`
`)==-1?[di]:di.split(/\n/gm);for(let Kn=0;Kn<Mr.length;Kn++){let cp=Mr[Kn];zt?(d.save(),d.translate(X,J+Kn*ui),d.rotate(zt),d.fillText(cp,0,0),d.restore()):d.fillText(cp,X,J+Kn*ui)}}}nt.show&&gn(Ci,nt.filter(n,At,w,Oe,bt),U,D,cn,ln,Ht(nt.width*It,3),nt.stroke(n,w),nt.dash,nt.cap);let os=C.grid;os.show&&gn(Ci,os.filter(n,At,w,Oe,bt),U,U==0?2:1,U==0?E:I,U==0?pe:q,Ht(os.width*It,3),os.stroke(n,w),os.dash,os.cap),Ke.show&&gn([cn],[1],U==0?1:0,U==0?1:2,U==1?E:I,U==1?pe:q,Ht(Ke.width*It,3),Ke.stroke(n,w),Ke.dash,Ke.cap)}Rn("drawAxes")}function pt(w){x.forEach((C,D)=>{D>0&&(C._paths=null,w&&(s==1?(C.min=null,C.max=null):C.facets.forEach(U=>{U.min=null,U.max=null})))})}let on=!1,qn=!1,Bt=[];function vn(){qn=!1;for(let w=0;w<Bt.length;w++)Rn(...Bt[w]);Bt.length=0}function On(){on||(tE($f),on=!0)}function Ll(w,C=!1){on=!0,qn=C,w(n),$f(),C&&Bt.length>0&&queueMicrotask(vn)}n.batch=Ll;function $f(){if(oe&&(_t(),oe=!1),Me&&(Re(),Me=!1),Se){if(Jt(p,Wa,tt),Jt(p,"top",ht),Jt(p,ml,V),Jt(p,gl,Ne),Jt(g,Wa,tt),Jt(g,"top",ht),Jt(g,ml,V),Jt(g,gl,Ne),Jt(f,ml,rn),Jt(f,gl,pn),u.width=En(rn*It),u.height=En(pn*It),S.forEach(({_el:w,_show:C,_size:D,_pos:U,side:X})=>{if(w!=null)if(C){let J=X===3||X===0?D:0,le=X%2==1;Jt(w,le?"left":"top",U-J),Jt(w,le?"width":"height",D),Jt(w,le?"top":"left",le?ht:tt),Jt(w,le?"height":"width",le?Ne:V),pf(w,Wr)}else Si(w,Wr)}),Qr=Xs=ea=W=te=Z=j=Pe=R=null,ke=1,po(!0),tt!=Ce||ht!=Vt||V!=Xe||Ne!=je){pt(!1);let w=V/Xe,C=Ne/je;if(ge&&!ie&&de.left>=0){de.left*=w,de.top*=C,na&&gs(na,En(de.left),0,V,Ne),ia&&gs(ia,0,En(de.top),V,Ne);for(let D=0;D<ft.length;D++){let U=ft[D];U!=null&&(qt[D]*=w,Xn[D]*=C,gs(U,Fi(qt[D]),Fi(Xn[D]),V,Ne))}}if(Zt.show&&!re&&Zt.left>=0&&Zt.width>0){Zt.left*=w,Zt.width*=w,Zt.top*=C,Zt.height*=C;for(let D in Su)Jt(aa,D,Zt[D])}Ce=tt,Vt=ht,Xe=V,je=Ne}Rn("setSize"),Se=!1}rn>0&&pn>0&&(d.clearRect(0,0,u.width,u.height),Rn("drawClear"),A.forEach(w=>w()),Rn("draw")),Zt.show&&re&&(Il(Zt),re=!1),ge&&ie&&(Sr(null,!0,!1),ie=!1),ue.show&&ue.live&&_e&&(bu(),_e=!1),l||(l=!0,n.status=1,Rn("ready")),$s=!1,on=!1}n.redraw=(w,C)=>{Me=C||!1,w!==!1?Ys(M,P.min,P.max):On()};function _u(w,C){let D=y[w];if(D.from==null){if(an==0){let U=D.range(n,C.min,C.max,w);C.min=U[0],C.max=U[1]}if(C.min>C.max){let U=C.min;C.min=C.max,C.max=U}if(an>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;w==M&&D.distr==2&&an>0&&(C.min=Ji(C.min,e[0]),C.max=Ji(C.max,e[0]),C.min==C.max&&C.max++),H[w]=C,oe=!0,On()}}n.setScale=_u;let yu,xu,na,ia,Xf,qf,sa,ra,Yf,Zf,Yt,Qt,qs=!1,kn=de.drag,An=kn.x,Cn=kn.y;ge&&(de.x&&(yu=ki(EM,g)),de.y&&(xu=ki(TM,g)),P.ori==0?(na=yu,ia=xu):(na=xu,ia=yu),Yt=de.left,Qt=de.top);let Zt=n.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),aa=Zt.show?ki(MM,Zt.over?g:p):null;function Il(w,C){if(Zt.show){for(let D in w)Zt[D]=w[D],D in Su&&Jt(aa,D,w[D]);C!==!1&&Rn("setSelect")}}n.setSelect=Il;function Dv(w){if(x[w].show)Q&&pf(he[w],Wr);else if(Q&&Si(he[w],Wr),ge){let D=De?ft[0]:ft[w];D!=null&&gs(D,-10,-10,V,Ne)}}function Ys(w,C,D){_u(w,{min:C,max:D})}function ss(w,C,D,U){C.focus!=null&&Ov(w),C.show!=null&&x.forEach((X,J)=>{J>0&&(w==J||w==null)&&(X.show=C.show,Dv(J),s==2?(Ys(X.facets[0].scale,null,null),Ys(X.facets[1].scale,null,null)):Ys(X.scale,null,null),On())}),D!==!1&&Rn("setSeries",w,C),U&&mo("setSeries",n,w,C)}n.setSeries=ss;function Nv(w,C){xn(T[w],C)}function kv(w,C){w.fill=Et(w.fill||null),w.dir=Ct(w.dir,-1),C=C??T.length,T.splice(C,0,w)}function Fv(w){w==null?T.length=0:T.splice(w,1)}n.addBand=kv,n.setBand=Nv,n.delBand=Fv;function Uv(w,C){x[w].alpha=C,ge&&ft[w]!=null&&(ft[w].style.opacity=C),Q&&he[w]&&(he[w].style.opacity=C)}let Ss,Zs,wr,oa={focus:!0};function Ov(w){if(w!=wr){let C=w==null,D=He.alpha!=1;x.forEach((U,X)=>{if(s==1||X>0){let J=C||X==0||X==w;U._focus=C?null:J,D&&Uv(X,J?1:He.alpha)}}),wr=w,D&&On()}}Q&&st&&ut(Ig,Te,w=>{de._lock||(it(w),wr!=null&&ss(null,oa,!0,_n.setSeries))});function rs(w,C,D){let U=y[C];D&&(w=w/It-(U.ori==1?ht:tt));let X=V;U.ori==1&&(X=Ne,w=X-w),U.dir==-1&&(w=X-w);let J=U._min,le=U._max,ve=w/X,Ee=J+(le-J)*ve,Oe=U.distr;return Oe==3?qa(10,Ee):Oe==4?HM(Ee,U.asinh):Oe==100?U.bwd(Ee):Ee}function Bv(w,C){let D=rs(w,M,C);return Ji(D,e[0],un,dn)}n.valToIdx=w=>Ji(w,e[0]),n.posToIdx=Bv,n.posToVal=rs,n.valToPos=(w,C,D)=>y[C].ori==0?r(w,y[C],D?q:V,D?I:0):a(w,y[C],D?pe:Ne,D?E:0),n.setCursor=(w,C,D)=>{Yt=w.left,Qt=w.top,Sr(null,C,D)};function Kf(w,C){Jt(aa,Wa,Zt.left=w),Jt(aa,ml,Zt.width=C)}function jf(w,C){Jt(aa,"top",Zt.top=w),Jt(aa,gl,Zt.height=C)}let uo=P.ori==0?Kf:jf,fo=P.ori==1?Kf:jf;function zv(){if(Q&&ue.live)for(let w=s==2?1:0;w<x.length;w++){if(w==0&&dt)continue;let C=ue.values[w],D=0;for(let U in C)Ie[w][D++].firstChild.nodeValue=C[U]}}function bu(w,C){if(w!=null&&(w.idxs?w.idxs.forEach((D,U)=>{ne[U]=D}):qM(w.idx)||ne.fill(w.idx),ue.idx=ne[0]),Q&&ue.live){for(let D=0;D<x.length;D++)(D>0||s==1&&!dt)&&Vv(D,ne[D]);zv()}_e=!1,C!==!1&&Rn("setLegend")}n.setLegend=bu;function Vv(w,C){let D=x[w],U=w==0&&k==2?ci:e[w],X;dt?X=D.values(n,w,C)??qe:(X=D.value(n,C==null?null:U[C],w,C),X=X==null?qe:{_:X}),ue.values[w]=X}function Sr(w,C,D){Yf=Yt,Zf=Qt,[Yt,Qt]=de.move(n,Yt,Qt),de.left=Yt,de.top=Qt,ge&&(na&&gs(na,En(Yt),0,V,Ne),ia&&gs(ia,0,En(Qt),V,Ne));let U,X=un>dn;Ss=Gt,Zs=null;let J=P.ori==0?V:Ne,le=P.ori==1?V:Ne;if(Yt<0||an==0||X){U=de.idx=null;for(let ve=0;ve<x.length;ve++){let Ee=ft[ve];Ee!=null&&gs(Ee,-10,-10,V,Ne)}st&&ss(null,oa,!0,w==null&&_n.setSeries),ue.live&&(ne.fill(U),_e=!0)}else{let ve,Ee,Oe;s==1&&(ve=P.ori==0?Yt:Qt,Ee=rs(ve,M),U=de.idx=Ji(Ee,e[0],un,dn),Oe=B(e[0][U],P,J,0));let Be=-10,Ve=-10,ct=0,Pt=0,At=!0,bt="",nt="";for(let Ke=s==2?1:0;Ke<x.length;Ke++){let Kt=x[Ke],ln=ne[Ke],Pn=ln==null?null:s==1?e[Ke][ln]:e[Ke][1][ln],zt=de.dataIdx(n,Ke,U,Ee),cn=zt==null?null:s==1?e[Ke][zt]:e[Ke][1][zt];if(_e=_e||cn!=Pn||zt!=ln,ne[Ke]=zt,Ke>0&&Kt.show){let hi=zt==null?-10:zt==U?Oe:B(s==1?e[0][zt]:e[Ke][0][zt],P,J,0),Yn=cn==null?-10:L(cn,s==1?y[Kt.scale]:y[Kt.facets[1].scale],le,0);if(st&&cn!=null){let Ai=P.ori==1?Yt:Qt,Bi=Tn(He.dist(n,Ke,zt,Yn,Ai));if(Bi<Ss){let as=He.bias;if(as!=0){let ui=rs(Ai,Kt.scale),Ci=cn>=0?1:-1,zi=ui>=0?1:-1;zi==Ci&&(zi==1?as==1?cn>=ui:cn<=ui:as==1?cn<=ui:cn>=ui)&&(Ss=Bi,Zs=Ke)}else Ss=Bi,Zs=Ke}}if(_e||De){let Ai,Bi;P.ori==0?(Ai=hi,Bi=Yn):(Ai=Yn,Bi=hi);let as,ui,Ci,zi,os,Zn,di=!0,Mr=fe.bbox;if(Mr!=null){di=!1;let Kn=Mr(n,Ke);Ci=Kn.left,zi=Kn.top,as=Kn.width,ui=Kn.height}else Ci=Ai,zi=Bi,as=ui=fe.size(n,Ke);if(Zn=fe.fill(n,Ke),os=fe.stroke(n,Ke),De)Ke==Zs&&Ss<=He.prox&&(Be=Ci,Ve=zi,ct=as,Pt=ui,At=di,bt=Zn,nt=os);else{let Kn=ft[Ke];Kn!=null&&(qt[Ke]=Ci,Xn[Ke]=zi,Bg(Kn,as,ui,di),Ug(Kn,Zn,os),gs(Kn,Fi(Ci),Fi(zi),V,Ne))}}}}if(De){let Ke=He.prox,Kt=wr==null?Ss<=Ke:Ss>Ke||Zs!=wr;if(_e||Kt){let ln=ft[0];ln!=null&&(qt[0]=Be,Xn[0]=Ve,Bg(ln,ct,Pt,At),Ug(ln,bt,nt),gs(ln,Fi(Be),Fi(Ve),V,Ne))}}}if(Zt.show&&qs)if(w!=null){let[ve,Ee]=_n.scales,[Oe,Be]=_n.match,[Ve,ct]=w.cursor.sync.scales,Pt=w.cursor.drag;if(An=Pt._x,Cn=Pt._y,An||Cn){let{left:At,top:bt,width:nt,height:Ke}=w.select,Kt=w.scales[Ve].ori,ln=w.posToVal,Pn,zt,cn,hi,Yn,Ai=ve!=null&&Oe(ve,Ve),Bi=Ee!=null&&Be(Ee,ct);Ai&&An?(Kt==0?(Pn=At,zt=nt):(Pn=bt,zt=Ke),cn=y[ve],hi=B(ln(Pn,Ve),cn,J,0),Yn=B(ln(Pn+zt,Ve),cn,J,0),uo(Qi(hi,Yn),Tn(Yn-hi))):uo(0,J),Bi&&Cn?(Kt==1?(Pn=At,zt=nt):(Pn=bt,zt=Ke),cn=y[Ee],hi=L(ln(Pn,ct),cn,le,0),Yn=L(ln(Pn+zt,ct),cn,le,0),fo(Qi(hi,Yn),Tn(Yn-hi))):fo(0,le)}else Mu()}else{let ve=Tn(Yf-Xf),Ee=Tn(Zf-qf);if(P.ori==1){let ct=ve;ve=Ee,Ee=ct}An=kn.x&&ve>=kn.dist,Cn=kn.y&&Ee>=kn.dist;let Oe=kn.uni;Oe!=null?An&&Cn&&(An=ve>=Oe,Cn=Ee>=Oe,!An&&!Cn&&(Ee>ve?Cn=!0:An=!0)):kn.x&&kn.y&&(An||Cn)&&(An=Cn=!0);let Be,Ve;An&&(P.ori==0?(Be=sa,Ve=Yt):(Be=ra,Ve=Qt),uo(Qi(Be,Ve),Tn(Ve-Be)),Cn||fo(0,le)),Cn&&(P.ori==1?(Be=sa,Ve=Yt):(Be=ra,Ve=Qt),fo(Qi(Be,Ve),Tn(Ve-Be)),An||uo(0,J)),!An&&!Cn&&(uo(0,0),fo(0,0))}if(kn._x=An,kn._y=Cn,w==null){if(D){if(lp!=null){let[ve,Ee]=_n.scales;_n.values[0]=ve!=null?rs(P.ori==0?Yt:Qt,ve):null,_n.values[1]=Ee!=null?rs(P.ori==1?Yt:Qt,Ee):null}mo(af,n,Yt,Qt,V,Ne,U)}if(st){let ve=D&&_n.setSeries,Ee=He.prox;wr==null?Ss<=Ee&&ss(Zs,oa,!0,ve):Ss>Ee?ss(null,oa,!0,ve):Zs!=wr&&ss(Zs,oa,!0,ve)}}_e&&(ue.idx=U,bu()),C!==!1&&Rn("setCursor")}let Ks=null;Object.defineProperty(n,"rect",{get(){return Ks==null&&po(!1),Ks}});function po(w=!1){w?Ks=null:(Ks=g.getBoundingClientRect(),Rn("syncRect",Ks))}function Jf(w,C,D,U,X,J,le){de._lock||qs&&w!=null&&w.movementX==0&&w.movementY==0||(wu(w,C,D,U,X,J,le,!1,w!=null),w!=null?Sr(null,!0,!0):Sr(C,!0,!1))}function wu(w,C,D,U,X,J,le,ve,Ee){if(Ks==null&&po(!1),it(w),w!=null)D=w.clientX-Ks.left,U=w.clientY-Ks.top;else{if(D<0||U<0){Yt=-10,Qt=-10;return}let[Oe,Be]=_n.scales,Ve=C.cursor.sync,[ct,Pt]=Ve.values,[At,bt]=Ve.scales,[nt,Ke]=_n.match,Kt=C.axes[0].side%2==1,ln=P.ori==0?V:Ne,Pn=P.ori==1?V:Ne,zt=Kt?J:X,cn=Kt?X:J,hi=Kt?U:D,Yn=Kt?D:U;if(At!=null?D=nt(Oe,At)?o(ct,y[Oe],ln,0):-10:D=ln*(hi/zt),bt!=null?U=Ke(Be,bt)?o(Pt,y[Be],Pn,0):-10:U=Pn*(Yn/cn),P.ori==1){let Ai=D;D=U,U=Ai}}Ee&&(C==null||C.cursor.event.type==af)&&((D<=1||D>=V-1)&&(D=Gr(D,V)),(U<=1||U>=Ne-1)&&(U=Gr(U,Ne))),ve?(Xf=D,qf=U,[sa,ra]=de.move(n,D,U)):(Yt=D,Qt=U)}let Su={width:0,height:0,left:0,top:0};function Mu(){Il(Su,!1)}let Qf,ep,tp,np;function ip(w,C,D,U,X,J,le){qs=!0,An=Cn=kn._x=kn._y=!1,wu(w,C,D,U,X,J,le,!0,!1),w!=null&&(ut(of,df,sp,!1),mo(Pg,n,sa,ra,V,Ne,null));let{left:ve,top:Ee,width:Oe,height:Be}=Zt;Qf=ve,ep=Ee,tp=Oe,np=Be}function sp(w,C,D,U,X,J,le){qs=kn._x=kn._y=!1,wu(w,C,D,U,X,J,le,!1,!0);let{left:ve,top:Ee,width:Oe,height:Be}=Zt,Ve=Oe>0||Be>0,ct=Qf!=ve||ep!=Ee||tp!=Oe||np!=Be;if(Ve&&ct&&Il(Zt),kn.setScale&&Ve&&ct){let Pt=ve,At=Oe,bt=Ee,nt=Be;if(P.ori==1&&(Pt=Ee,At=Be,bt=ve,nt=Oe),An&&Ys(M,rs(Pt,M),rs(Pt+At,M)),Cn)for(let Ke in y){let Kt=y[Ke];Ke!=M&&Kt.from==null&&Kt.min!=Gt&&Ys(Ke,rs(bt+nt,Ke),rs(bt,Ke))}Mu()}else de.lock&&(de._lock=!de._lock,Sr(C,!0,w!=null));w!=null&&(nn(of,df),mo(of,n,Yt,Qt,V,Ne,null))}function Gv(w,C,D,U,X,J,le){if(de._lock)return;it(w);let ve=qs;if(qs){let Ee=!0,Oe=!0,Be=10,Ve,ct;P.ori==0?(Ve=An,ct=Cn):(Ve=Cn,ct=An),Ve&&ct&&(Ee=Yt<=Be||Yt>=V-Be,Oe=Qt<=Be||Qt>=Ne-Be),Ve&&Ee&&(Yt=Yt<sa?0:V),ct&&Oe&&(Qt=Qt<ra?0:Ne),Sr(null,!0,!0),qs=!1}Yt=-10,Qt=-10,ne.fill(null),Sr(null,!0,!0),ve&&(qs=ve)}function rp(w,C,D,U,X,J,le){de._lock||(it(w),ho(),Mu(),w!=null&&mo(Dg,n,Yt,Qt,V,Ne,null))}function ap(){S.forEach(c1),z(n.width,n.height,!0)}$r(Hh,Xa,ap);let la={};la.mousedown=ip,la.mousemove=Jf,la.mouseup=sp,la.dblclick=rp,la.setSeries=(w,C,D,U)=>{let X=_n.match[2];D=X(n,C,D),D!=-1&&ss(D,U,!0,!1)},ge&&(ut(Pg,g,ip),ut(af,g,Jf),ut(Lg,g,w=>{it(w),po(!1)}),ut(Ig,g,Gv),ut(Dg,g,rp),xf.add(n),n.syncRect=po);let Dl=n.hooks=i.hooks||{};function Rn(w,C,D){qn?Bt.push([w,C,D]):w in Dl&&Dl[w].forEach(U=>{U.call(null,n,C,D)})}(i.plugins||[]).forEach(w=>{for(let C in w.hooks)Dl[C]=(Dl[C]||[]).concat(w.hooks[C])});let op=(w,C,D)=>D,_n=xn({key:null,setSeries:!1,filters:{pub:Wg,sub:Wg},scales:[M,x[1]?x[1].scale:null],match:[$g,$g,op],values:[null,null]},de.sync);_n.match.length==2&&_n.match.push(op),de.sync=_n;let lp=_n.key,Eu=V0(lp);function mo(w,C,D,U,X,J,le){_n.filters.pub(w,C,D,U,X,J,le)&&Eu.pub(w,C,D,U,X,J,le)}Eu.sub(n);function Hv(w,C,D,U,X,J,le){_n.filters.sub(w,C,D,U,X,J,le)&&la[w](null,C,D,U,X,J,le)}n.pub=Hv;function Wv(){Eu.unsub(n),xf.delete(n),Dt.clear(),mf(Hh,Xa,ap),c.remove(),Te?.remove(),Rn("destroy")}n.destroy=Wv;function Tu(){Rn("init",i,e),co(e||i.data,!1),H[M]?_u(M,H[M]):ho(),re=Zt.show&&(Zt.width>0||Zt.height>0),ie=_e=!0,z(i.width,i.height)}return x.forEach(Jr),S.forEach(ys),t?t instanceof HTMLElement?(t.appendChild(c),Tu()):t(n,Tu):Tu(),n}Nn.assign=xn;Nn.fmtNum=Af;Nn.rangeNum=Wh;Nn.rangeLog=qh;Nn.rangeAsinh=Ef;Nn.orient=qr;Nn.pxRatio=It;Nn.join=eE;Nn.fmtDate=Rf,Nn.tzDate=uE;Nn.sync=V0;{Nn.addGap=qE,Nn.clipGaps=Kh;let i=Nn.paths={points:q0};i.linear=Z0,i.stepped=KE,i.bars=jE,i.spline=QE}var h1=62,u1={measured:{width:2},before:{width:1.25,dash:[5,3]},after:{width:1.25}},d1=0,eo=class{constructor(e,t=()=>{}){this.moved=e;this.zoomed=t;ha(()=>this.clear()),new ResizeObserver(()=>this.resize()).observe(this.element),this.element.addEventListener("wheel",n=>this.wheel(n),{passive:!1}),this.element.addEventListener("dblclick",()=>this.reset())}moved;zoomed;key=`plots-${d1++}`;element=h("div",{class:"plots"});plots=[];heads=[];marks=[];shown=null;range=[0,1];busy=!1;place=0;show(e,t=null){if(this.refresh(e,t))return;this.clear(),this.shown=e;let{x:n}=e,s=n[0],r=n[n.length-1];this.range=t??e.window??[s,r],e.panes.forEach((a,o)=>this.add(a,o===e.panes.length-1)),this.mark(this.place),this.zoomed(this.range)}refresh(e,t){let n=r=>JSON.stringify([r.xLabel,r.panes.map(a=>[a.title,a.unit,a.lines.map(o=>[o.label,o.role])])]);if(!this.shown||n(this.shown)!==n(e))return!1;this.shown=e;let{x:s}=e;return this.range=t??e.window??[s[0],s[s.length-1]],e.panes.forEach((r,a)=>{let o=this.plots[a];r.lines.forEach((l,c)=>{o.series[c+1].show!==l.shown&&o.setSeries(c+1,{show:l.shown})}),o.setData([s,...r.lines.map(l=>l.y)])}),this.mark(this.place),this.zoomed(this.range),!0}clear(){this.shown=null;for(let e of this.plots)e.destroy();this.plots=[],this.heads=[],this.marks=[],this.element.replaceChildren()}get window(){return this.range}get whole(){let e=this.shown?.x;return this.shown?.whole?this.shown.whole:e&&e.length?[e[0],e[e.length-1]]:[0,1]}reset(){this.zoom(...this.whole)}zoom(e,t){let[n,s]=this.whole,r=(s-n)*(this.shown?.whole?1e-7:1e-4)||1,a=Math.min(Math.max(t-e,r),s-n),o=Math.min(Math.max(e,n),s-a);this.range=[o,o+a],this.busy=!0;for(let l of this.plots)l.setScale("x",{min:this.range[0],max:this.range[1]});this.busy=!1,this.mark(this.place),this.zoomed(this.range)}zoomBy(e,t=(this.range[0]+this.range[1])/2){this.zoom(t-(t-this.range[0])*e,t+(this.range[1]-t)*e)}pan(e){let t=this.range[1]-this.range[0];this.zoom(this.range[0]+e*t,this.range[1]+e*t)}setShown(e,t){this.shown?.panes.forEach((n,s)=>n.lines.forEach((r,a)=>{r.role===e&&(r.shown=t,this.plots[s].setSeries(a+1,{show:t}))})),this.mark(this.place)}mark(e){this.place=e;let t=this.shown;t&&t.panes.forEach((n,s)=>{let r=this.plots[s],a=r.valToPos(e,"x"),o=e>=this.range[0]&&e<=this.range[1];this.marks[s].style.transform=`translateX(${a}px)`,this.marks[s].hidden=!o;let l=this.heads[s].querySelectorAll("output");n.lines.forEach((c,u)=>{let d=l[u];d.parentElement.hidden=!c.shown,c.shown&&(d.textContent=vo(Li(t.x,c.y,e),c.step))})})}repaint(){let{shown:e,range:t}=this;e&&(this.clear(),this.show(e,t))}add(e,t){let n=this.shown,s=h("div",{class:"pane-head"},h("span",{},h("b",{},e.title),h("span",{class:"unit"},` [${e.unit||"–"}]`)));for(let p of e.lines)s.append(h("span",{class:"value"},...p.label?[h("i",{class:`swatch ${p.role}`}),`${p.label} `]:[],h("output",{},"–")));let r=h("div",{class:"pane"});this.element.append(s,r);let a=xt("ink"),o={stroke:xt("line"),width:1},l=xt("span"),c="12px system-ui, sans-serif",u=(p,g)=>p1(g),d=f1(()=>new Nn({width:Math.max(this.element.clientWidth,200),height:this.height(t),padding:[6,12,0,0],legend:{show:!1},cursor:{sync:{key:this.key,setSeries:!1},drag:{x:!0,y:!1,setScale:!1},points:{show:!1},y:!1,bind:{dblclick:()=>null}},scales:{x:{time:!1,auto:!1,range:()=>this.range},y:{range:(p,g,_)=>m1(g,_)}},axes:[{stroke:a,grid:o,ticks:{show:!1},size:t?24:6,font:c,values:t?u:()=>[],label:t?n.xLabel:void 0,labelSize:16,labelFont:c,labelGap:0,gap:3},{stroke:a,grid:o,ticks:{show:!1},size:h1,font:c,values:u}],series:[{},...e.lines.map(p=>{let g=u1[p.role]??{width:1.25};return{label:p.label,stroke:xt(p.role),points:{show:!1},show:p.shown,...g}})],hooks:{drawClear:[p=>{p.ctx.fillStyle=l;for(let[g,_]of n.spans){let m=Math.max(g,this.range[0]),v=Math.min(_,this.range[1]);v>m&&p.ctx.fillRect(p.valToPos(m,"x",!0),p.bbox.top,p.valToPos(v,"x",!0)-p.valToPos(m,"x",!0),p.bbox.height)}}],setSelect:[p=>{p.select.width>4&&this.zoom(p.posToVal(p.select.left,"x"),p.posToVal(p.select.left+p.select.width,"x")),p.setSelect({left:0,top:0,width:0,height:0},!1)}],setCursor:[p=>{this.busy||p.cursor.left===void 0||p.cursor.left===null||p.cursor.left<0||!p.cursor.event||this.moved(p.posToVal(p.cursor.left,"x"))}]}},[n.x,...e.lines.map(p=>p.y)],r)),f=h("div",{class:"mark-line"});d.over.append(f),d.over.style.touchAction="pan-y",this.plots.push(d),this.heads.push(s),this.marks.push(f)}height(e){let t=this.shown?.panes.length??1;return(t>3?96:t===3?120:t===2?165:250)+(e?40:6)+6}resize(){let e=this.element.clientWidth;e<50||(this.plots.forEach((t,n)=>t.setSize({width:e,height:this.height(n===this.plots.length-1)})),this.mark(this.place))}wheel(e){if(!e.ctrlKey&&!e.shiftKey)return;e.preventDefault();let t=this.plots[0];t&&(e.shiftKey?this.pan(Math.sign(e.deltaY||e.deltaX)*.1):this.zoomBy(e.deltaY>0?1.25:.8,t.posToVal(e.clientX-t.over.getBoundingClientRect().left,"x")))}};function f1(i){if(_o())return i();let e=HTMLCanvasElement.prototype,t=e.getContext;e.getContext=function(n,s){return t.call(this,n,n==="2d"?{...s,willReadFrequently:!0}:s)};try{return i()}finally{e.getContext=t}}function p1(i){let e=i.map(n=>String(Number(n.toPrecision(10))));if(e.some(n=>n.includes("e")))return e.map(fi);let t=Math.max(0,...e.map(n=>n.split(".")[1]?.length??0));return i.map(n=>fi(n===0?"0":n.toFixed(t)))}function m1(i,e){if(i===null||e===null)return[0,1];if(e>i)return Nn.rangeNum(i,e,.1,!0);let t=.1*Math.abs(i)||1;return[i-t,i+t]}var g1=[1,2,5,10,20,50,100],v1=matchMedia("(max-width: 40rem)").matches?6:16,Q0=matchMedia("(prefers-reduced-motion: reduce)"),vs=class{constructor(e,t){this.model=e;this.store=t;this.scene=e.scenes[0],this.view=e.scenes.some(n=>n.motion)?new dr(e.stage):null,e.scenes.forEach((n,s)=>this.choice.append(h("option",{value:String(s)},n.label))),this.build(),this.show(this.scene),ha(()=>{this.isGone=!0}),jn(()=>{this.plots.repaint(),this.view?.repaint()})}model;store;element=h("div",{class:"player",tabindex:"-1"});plots=new eo(e=>{this.playing||this.goTo(e)},e=>this.seen(e));view;choice=h("select",{"aria-label":St("choice")});note=h("span",{class:"mark"});overlays=h("div",{class:"group overlays",role:"group","aria-label":St("curves")});channels=h("div",{class:"group channels",role:"group","aria-label":St("channels")});play=h("button",{type:"button",class:"play"},St("play"));slider=h("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":""});clock=h("output",{class:"clock"});speed=h("select",{"aria-label":St("speed")});roles=new Map;panes=new Map;livelyPart=h("button",{type:"button",title:St("zoomToEvent"),click:()=>this.lively()},St("event"));scene;now=0;playing=!1;isStepping=!1;isGone=!1;way=1;last=0;moved=null;lacking=null;frames=[];choose(e){let t=this.model.scenes.findIndex(n=>n.name===e);return t<0?!1:(this.choice.value=String(t),this.show(this.model.scenes[t]),!0)}replace(e,t){let n=e.x.words!==this.model.x.words,s=Math.max(this.model.scenes.indexOf(this.scene),0),r=this.plots.window,[a,o]=this.plots.whole,l=e.scenes[Math.min(s,e.scenes.length-1)],c=n||r[0]<=a&&r[1]>=o;(e.roles.map(d=>d.label).join()!==this.model.roles.map(d=>d.label).join()||e.roles.length!==this.model.roles.length)&&this.offerRoles(e),this.model=e,this.store=t,this.scene=l;let u=t.get(l.x);n&&this.offer(l),this.view&&(this.view.element.hidden=!l.motion),this.slider.min=String(u[0]),this.slider.max=String(u[u.length-1]),this.plot(c?null:r),l.motion&&this.view&&this.view.show(t.content.mechanisms[l.motion.mechanism],l.motion),this.goTo(this.now)}zoom(e,t){this.plots.zoom(e,t)}get shown(){return this.scene.panes.filter(e=>this.isShown(e)).map(e=>e.name)}goTo(e){let[t,n]=this.plots.whole;this.now=Math.min(Math.max(e,t),n),this.slider.value=String(this.now),this.clock.textContent=`${fi(this.now.toFixed(3))} ${this.model.x.unit}`,this.plots.mark(this.now),this.moved?.(this.now);let s=this.scene.motion;if(s&&this.view){let r=this.store.get(this.scene.x),a=o=>Li(r,this.store.get(o),this.now);this.view.set({body:a(s.body),travel:a(s.travel),ground:a(s.ground),load:a(s.load),time:this.now})}}build(){let{model:e}=this;this.offerRoles(e);let t=u=>()=>this.stepScene(u),n=h("div",{class:"group"},h("button",{type:"button",title:St("previous"),click:t(-1)},"‹"),this.choice,h("button",{type:"button",title:St("next"),click:t(1)},"›"),this.note);this.choice.addEventListener("change",()=>this.show(e.scenes[Number(this.choice.value)])),e.scenes.length<2&&(n.hidden=!0);let s=h("div",{class:"group"},h("button",{type:"button",title:St("zoomIn"),click:()=>this.plots.zoomBy(.5,this.now)},"+"),h("button",{type:"button",title:St("zoomOut"),click:()=>this.plots.zoomBy(2,this.now)},"−"),h("button",{type:"button",title:St("everything"),click:()=>this.plots.reset()},St("all")),this.livelyPart),r=pi(St("wide"),!1,u=>{this.element.classList.toggle("wide",u),document.body.classList.toggle("behind",u)},St("fillWindow"));r.classList.add("widen");let a=e.x.unit==="s",o=e.slower??(a?10:2),l=[...new Set([...g1,o])].sort((u,d)=>u-d);for(let u of l)this.speed.append(h("option",{value:String(u)},u>1?`1/${u}`:St(a?"realTime":"fast")));this.speed.value=String(o),this.play.addEventListener("click",()=>this.toggle()),this.slider.addEventListener("input",()=>{this.pause(),this.goTo(Number(this.slider.value))});let c=h("div",{class:this.view?e.stage?"stage-and-plots stage-first":"stage-and-plots":"plots-only"},this.plots.element);this.view&&c.append(this.view.element),this.element.append(h("div",{class:"bar"},n,this.overlays,h("span",{class:"grow"}),s,r),h("div",{class:"bar"},this.channels),c,h("div",{class:"bar transport"},this.play,this.slider,this.clock,h("label",{},`${St("speed")} `,this.speed)),h("p",{class:"hint"},St("hint"))),this.element.addEventListener("keydown",u=>this.key(u))}offerRoles(e){let t=e.roles.map(({role:n,label:s,shown:r})=>{this.roles.has(n)||this.roles.set(n,r);let a=pi(s,this.roles.get(n),o=>{this.roles.set(n,o),this.plots.setShown(n,o)});return a.prepend(h("i",{class:`swatch ${n}`})),a});this.overlays.replaceChildren(...t),this.overlays.hidden=t.length<2}show(e){let t=this.scene===e?null:this.keptWindow(e);this.scene=e,this.note.textContent=e.note,this.note.parentElement.className=`group ${e.tone}`,this.note.hidden=!e.note,this.livelyPart.hidden=!e.window;let n=this.store.get(e.x);this.offer(e),this.slider.min=String(n[0]),this.slider.max=String(n[n.length-1]),this.plot(t),e.motion&&this.view&&this.view.show(this.store.content.mechanisms[e.motion.mechanism],e.motion),this.goTo(this.now)}offer(e){let t=e.panes.length>v1,n=0,s=e.panes.length<2?[]:e.panes.map(r=>{let a=this.isShown(r),o=pi(r.name,a,l=>{this.panes.set(r.name,l),l&&this.scene.panes.some(c=>c.name===r.name&&!c.curves.length)?this.lacking?.():this.plot(this.plots.window)},r.words);return t&&!a&&(o.classList.add("other"),n++),o});if(n){let r=this.channels.classList.contains("every");s.push(pi(St("more",String(n)),r,a=>{this.channels.classList.toggle("every",a)},St("otherChannels")))}this.channels.replaceChildren(...s)}plot(e){let{scene:t}=this,n=t.panes.filter(s=>this.isShown(s)&&s.curves.length);n.length||(n=t.panes.filter(s=>s.curves.length).slice(0,1)),this.slider.setAttribute("aria-label",this.model.x.words),this.plots.show({x:this.store.get(t.x),xLabel:`${this.model.x.words} [${this.model.x.unit}]`,spans:t.spans,window:t.window,panes:n.map(s=>({title:s.words,unit:s.unit,lines:s.curves.map(r=>({label:this.model.roles.length>1?r.label:"",role:r.role,y:this.store.get(r.y),step:this.store.step(r.y),shown:this.roles.get(r.role)??!0}))}))},e),this.plots.mark(this.now)}isShown(e){return this.panes.get(e.name)??e.shown}keptWindow(e){let[t,n]=this.plots.window,[s,r]=this.plots.whole,a=this.store.get(e.x);if(t<=s&&n>=r)return[a[0],a[a.length-1]];let o=this.scene.window;return o&&Math.abs(t-o[0])<1e-9&&Math.abs(n-o[1])<1e-9?null:t>=a[0]&&n<=a[a.length-1]?[t,n]:null}lively(){this.scene.window?this.plots.zoom(...this.scene.window):this.plots.reset()}stepScene(e){let{scenes:t}=this.model,n=(t.indexOf(this.scene)+e+t.length)%t.length;this.choose(t[n].name)}seen([e,t]){(this.now<e||this.now>t)&&this.goTo(e)}toggle(){this.playing?this.pause():this.start()}start(){let[e,t]=this.plots.window;(this.now>=t-1e-9*(t-e)||this.now<e)&&this.goTo(e),this.playing=!0,this.way=1,this.last=0,this.frames.length=0,this.play.textContent=St("pause"),this.isStepping||requestAnimationFrame(n=>this.step(n)),this.isStepping=!0}get rate(){let[e,t]=this.plots.whole;return this.model.x.unit==="s"?1:(t-e)/2}pause(){this.playing=!1,this.play.textContent=St("play")}step(e){if(this.isStepping=this.playing&&!this.isGone,!this.isStepping)return;let t=this.last?e-this.last:0;this.last&&(this.frames.push(t),this.frames.length>600&&this.frames.shift()),this.last=e;let[n,s]=this.plots.window,r=this.now+this.way*this.rate*Math.min(t,250)/1e3/Number(this.speed.value);(r>s||r<n)&&(Q0.matches&&this.pause(),this.model.x.unit!=="s"&&(this.way=-this.way),r=Q0.matches||this.model.x.unit!=="s"?Math.min(Math.max(r,n),s):n),this.goTo(r),this.view?.draw(),requestAnimationFrame(a=>this.step(a))}key(e){if(e.ctrlKey||e.metaKey||e.altKey||e.target instanceof HTMLSelectElement)return;let t=e.target instanceof HTMLButtonElement,n=e.target===this.slider,s=this.store.get(this.scene.x),r=(s[s.length-1]-s[0])/Math.max(s.length-1,1),a={"+":()=>this.plots.zoomBy(.5,this.now),"=":()=>this.plots.zoomBy(.5,this.now),"-":()=>this.plots.zoomBy(2,this.now),0:()=>this.plots.reset(),9:()=>this.lively(),"[":()=>this.stepScene(-1),"]":()=>this.stepScene(1),f:()=>this.element.querySelector(".widen").click(),...t?{}:{" ":()=>this.toggle()},...n?{}:{ArrowLeft:()=>{this.pause(),this.goTo(this.now-r*(e.shiftKey?20:1))},ArrowRight:()=>{this.pause(),this.goTo(this.now+r*(e.shiftKey?20:1))}}};e.key==="Escape"&&this.element.classList.contains("wide")&&(a.Escape=a.f);let o=a[e.key];o&&(e.preventDefault(),o())}};function me(i,e,t=""){return h("label",{class:"field"},h("span",{},i),e,...t?[h("small",{},t)]:[])}function vt(i){return h("p",{class:"problem",role:"alert"},i instanceof Error?i.message:String(i))}function $n(i,e){return i.disabled=!0,e.finally(()=>{i.disabled=!1})}function Yr(i,e){let t=h("button",{type:"button"},F("Copy")),n=h("pre",{tabindex:"0","aria-label":i},e);return t.addEventListener("click",()=>{navigator.clipboard.writeText(n.textContent).then(()=>{t.textContent=F("Copied")},()=>{t.textContent=F("Select and copy")})}),h("section",{class:"code"},h("div",{class:"bar"},h("h3",{},i),t),n)}function Ff({python:i,command:e,files:t}){return[Yr(F("The same in Python"),i),Yr(F("The same on the command line"),e),...Object.entries(t).map(([n,s])=>Yr(n,s))]}var bl=class{element=h("div",{class:"ways"});show({python:e,command:t,files:n}){let s=[e,t,...Object.values(n)],r=this.element.querySelectorAll("pre");r.length===s.length?r.forEach((a,o)=>{a.textContent!==s[o]&&(a.textContent=s[o])}):this.element.replaceChildren(...Ff({python:e,command:t,files:n}))}},Vs=class{busy=!1;next=null;async ask(e){if(this.next=e,!this.busy){this.busy=!0;try{for(;this.next;){let t=this.next;this.next=null,await t()}}finally{this.busy=!1}}}},to=class{constructor(e,t,n,s={}){this.moved=n;let r=this.known;for(let l of e.numbers)r.set(l.path,l);let a=h("select",{"aria-label":F("another number")},h("option",{value:""},F("another number …")));for(let{path:l}of e.numbers)a.append(h("option",{value:l},l));a.addEventListener("change",()=>{let l=r.get(a.value);l&&this.add(l),a.value=""});for(let l of t){let c=r.get(l);c&&this.add(c)}for(let[l,c]of Object.entries(s)){let u=r.get(l);u&&Number.isFinite(c)&&(this.add(u),this.set(l,c))}let o=h("button",{type:"button"},F("All as they were"));o.addEventListener("click",()=>{for(let l of Object.keys(this.changes))delete this.changes[l];this.rows.querySelectorAll("input").forEach(l=>{l.value=l.defaultValue}),this.moved()}),this.element.append(this.rows,h("div",{class:"bar"},a,o))}moved;element=h("div",{class:"sliders"});changes={};rows=h("div",{});known=new Map;set(e,t){let n=this.known.get(e);if(!n)return;let s=Number((t*n.factor).toPrecision(7)),r=this.rows.querySelector(`[data-path="${CSS.escape(e)}"]`);Math.abs(t-n.value)<=1e-12*Math.max(Math.abs(t),1)?delete this.changes[e]:this.changes[e]=t,r?.querySelectorAll("input").forEach(a=>{a.value=String(s)})}add(e){if(this.rows.querySelector(`[data-path="${CSS.escape(e.path)}"]`))return;let t=e.value*e.factor,n=.5*Math.abs(t)||1,s=String(Number(t.toPrecision(6))),r=`${e.path} [${e.unit||"–"}]`,a=h("input",{type:"range",min:String(t-n),max:String(t+n),step:String(n/100),value:s,"aria-label":r}),o=h("input",{type:"number",step:"any",value:s,"aria-label":`${r}, ${F("typed")}`}),l=c=>{let u=Number(c);c===""||!Number.isFinite(u)||(c===s?delete this.changes[e.path]:this.changes[e.path]=u/e.factor,this.moved())};a.addEventListener("input",()=>{o.value=String(Number(Number(a.value).toPrecision(5))),l(o.value)}),o.addEventListener("input",()=>{a.value=o.value,l(o.value)}),this.rows.append(h("div",{class:"slider","data-path":e.path},h("span",{class:"name"},e.path),a,o,h("span",{class:"unit"},e.unit||"–")))}},eu=class{constructor(e){this.question=e;this.element.append(this.state,this.place,this.same.element)}question;element=h("div",{class:"live"});state=h("p",{class:"state",role:"status"});place=h("div",{});same=new bl;player=null;busy=!1;again=!1;shown=null;moved=null;times=[];async ask(){if(this.again=this.busy,this.busy)return;this.busy=!0;let e=performance.now(),t=setTimeout(()=>{this.state.textContent=F("computing; the first time a model is compiled once, which takes some seconds")},500);try{let n=zn.of(await this.question(this.player?.shown??[]));if(!this.element.isConnected)return;let s=n.content.viewers[0];this.player?this.player.replace(s,n):(this.player=new vs(s,n),this.place.replaceChildren(this.player.element),this.player.moved=r=>this.moved?.(r),this.player.lacking=()=>{this.ask()}),this.shown?.(s,n),this.same.show(n.content),this.times.push(performance.now()-e),this.state.textContent=`${F("computed and drawn in")} ${xe(this.times[this.times.length-1],2)} ms`,this.state.classList.remove("problem")}catch(n){this.state.textContent=n instanceof Error?n.message:String(n),this.state.classList.add("problem")}finally{clearTimeout(t),this.busy=!1,this.again&&this.ask()}}};var wl=async(i,e,t)=>(await Bn(i,e,t)).json(),mr=i=>wl("POST","/api/jobs",i),Of=i=>wl("POST","/api/ask",i),gr=i=>en(`/api/jobs/${encodeURIComponent(i)}`),io=new Map,nu=null,no=null,tu=1e3,ev=h("p",{class:"problem",role:"alert"},"The server does not tell about jobs any more; those that run go on. Start it again with jounce serve, and open the address that it prints.");function nv(){no=new WebSocket(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/api/live`),no.addEventListener("message",i=>{tu=1e3,ev.remove(),nu=JSON.parse(i.data),_1()}),no.addEventListener("close",()=>{if(no=null,![...io.values()].some(i=>i.node.isConnected)){io.clear();return}document.getElementById("main").prepend(ev),setTimeout(()=>{io.size&&!no&&nv()},tu),tu=Math.min(2*tu,3e4)})}function _1(){for(let[i,e]of io)e.node.isConnected&&(e.shown=!0),e.node.isConnected||!e.shown?i(nu):io.delete(i)}function vr(i,e){io.set(e,{node:i,shown:!1}),nu&&e(nu),no||nv()}var y1={running:"running",cancelling:"stopping",done:"done",failed:"failed",cancelled:"cancelled",stopped:"stopped"},x1={running:"plain",cancelling:"fair",done:"good",failed:"bad",cancelled:"fair",stopped:"bad"};function Uf(i){let e=Math.max(0,Math.round(i));return e<60?`${e} s`:e<3600?`${Math.floor(e/60)} min ${e%60} s`:`${Math.floor(e/3600)} h ${Math.floor(e%3600/60)} min`}var Gs=class{constructor(e,t){this.job=e;this.open=t;this.bar.setAttribute("aria-label",Vi(`share of ${e.title} that is done`)),this.element.append(h("div",{class:"bar"},h("h3",{},e.title),this.state,this.times),this.bar,this.said,this.told,this.actions),this.show(e)}job;open;element=h("article",{class:"job"});state=h("span",{class:"mark"});times=h("span",{class:"muted"});said=h("p",{class:"state",role:"status"});bar=h("progress",{max:"1"});actions=h("div",{class:"bar"});told=h("div",{});shown="";timer=0;show(e){this.job=e;let t=e.state==="running"||e.state==="cancelling";if(this.state.textContent=F(y1[e.state]),this.state.className=`mark ${x1[e.state]}`,this.bar.hidden=!t,e.share===null?this.bar.removeAttribute("value"):this.bar.value=e.share,this.said.hidden=!t,this.said.textContent=F(e.state==="cancelling"?"stopping; what is finished is kept":Vi(e.said)||"starting"),this.tick(),clearInterval(this.timer),t&&(this.timer=window.setInterval(()=>{this.element.isConnected?this.tick():clearInterval(this.timer)},1e3)),this.shown===e.state)return;this.shown=e.state,this.told.replaceChildren(...e.error?[vt(mi(e.error))]:[]);let n=(r,a,o=!1)=>{let l=h("button",{type:"button",...o?{class:"main"}:{},"aria-label":`${r}: ${e.title}`},r);return l.addEventListener("click",()=>{l.disabled=!0,a().catch(c=>{this.told.replaceChildren(vt(c)),l.disabled=!1})}),l},s=`/api/jobs/${encodeURIComponent(e.id)}`;this.actions.replaceChildren(...e.state==="running"?[n("Cancel",()=>wl("POST",`${s}/cancel`,{}))]:[],...this.open&&(e.state==="done"||e.kind==="sweep")?[n("Show the results",async()=>this.open(this.job),!0)]:[],...!t&&e.state!=="done"?[n(e.kind==="sweep"?"Resume":"Begin again",()=>wl("POST",`${s}/again`,{}),!0)]:[],...t?[]:[n("Take off the list",()=>wl("DELETE",s))]),this.actions.append(h("details",{},h("summary",{},"In Python, and on the command line"),Un(e)))}tick(){let{begun:e,ended:t,share:n,left:s,state:r}=this.job,a=(t??Date.now()/1e3)-e,o=[t?F("took #",Uf(a)):F("for #",Uf(a))];r==="running"&&n!==null&&o.push(`${xe(100*n,3)} %`),r==="running"&&s!==null&&s>=1&&o.push(F("about # left",Uf(s))),this.times.textContent=o.join(" · ")}};function _r(i,e,t){let n=h("div",{class:"jobs"},h("p",{class:"muted"},"asking …")),s=new Map;return vr(n,r=>{let a=r.filter(l=>!i||i.includes(l.kind));for(let l of a){let c=s.get(l.id);c?c.show(l):s.set(l.id,new Gs(l,e))}for(let l of[...s.keys()])a.some(c=>c.id===l)||s.delete(l);let o=a.map(l=>s.get(l.id).element);o.length?(o.some((l,c)=>n.children[c]!==l)||n.children.length!==o.length)&&n.replaceChildren(...o):n.replaceChildren(h("p",{class:"empty"},t))}),n}function Un(i){return h("div",{class:"ways"},...i.python?[Yr("The same in Python",i.python)]:[],...i.command?[Yr("The same on the command line",i.command)]:[],...Object.entries(i.files??{}).map(([e,t])=>Yr(e,t)))}function iv(i){return(i?.findings??[]).filter(t=>t.severity==="problem").map(t=>vt(mi(t.message)))}function _s(i,e){return h("section",{class:"whole"},h("div",{class:"bar"},h("h2",{},e),h("a",{href:i,target:"_blank",rel:"noopener"},"open it in a tab of its own")),h("iframe",{src:i,title:e,sandbox:"allow-scripts",class:"report"}))}function iu(i,e,t){let n=h("input",{type:"file",multiple:!0,"aria-label":e}),s=h("div",{"aria-live":"polite"}),r=h("div",{class:"drop"},h("p",{},e),n,s),a=async o=>{let l=[],c=[];for(let u of o??[]){let d=[i().replace(/\/+$/,""),u.name].filter(Boolean).join("/");s.replaceChildren(h("p",{class:"state"},`${u.name}: ${xe(u.size/1e6,3)} MB on the way …`));try{await b1(d,u),l.push(d)}catch(f){c.push(vt(f))}}s.replaceChildren(...c,...l.length?[h("p",{class:"good"},`${l.join(", ")}: here now.`)]:[]),n.value="",l.length&&t(l)};return n.addEventListener("change",()=>{a(n.files)}),r.addEventListener("dragover",o=>{o.preventDefault(),r.classList.add("over")}),r.addEventListener("dragleave",()=>r.classList.remove("over")),r.addEventListener("drop",o=>{o.preventDefault(),r.classList.remove("over"),a(o.dataTransfer?.files??null)}),r}var tv=25e7;async function b1(i,e){if(e.size>tv)throw new Error(`${e.name}: ${xe(e.size/1e6,3)} MB; at most ${tv/1e6} MB are taken here. Copy it into the folder instead.`);let t=await fetch(`/api/upload?${new URLSearchParams({path:i})}`,{method:"PUT",body:e});if(t.ok)return;let n=await t.json().catch(()=>null);throw new Error(mi(n?.error?.text??`${e.name}: ${t.statusText}`))}var Ti=class{constructor(e,t,n){this.task=t;this.show=n;this.button=h("button",{type:"button",class:"main"},e),this.button.addEventListener("click",()=>{this.ask()})}task;show;button;place=h("div",{"aria-live":"polite"});asked=0;async ask(){let e=++this.asked;this.button.disabled=!0;let t=h("p",{class:"state"},"working …");this.place.prepend(t);let n;try{let s=await Of(this.task());n=()=>this.show(s)}catch(s){n=()=>[vt(s)]}t.remove(),e===this.asked&&(this.place.replaceChildren(...n()),this.button.disabled=!1)}};var w1=["time","sprung.z","sprung.az","unsprung.z","unsprung.az","strut.deflection","strut.force","tyre.force","road.z"];function S1(i){let e=(m,v,x="")=>{let S=document.createElementNS("http://www.w3.org/2000/svg",m);for(let[y,T]of Object.entries(v))S.setAttribute(y,String(T));return S.textContent=x,S},[t,n,s,r]=[520,300,62,34],a=m=>{let v=Math.min(0,...m.slice(0,1)),x=v;for(let S of m)v=Math.min(v,S),x=Math.max(x,S);return x>v?[v,x]:[v-1,x+1]},[o,l]=a(i.x),[c,u]=a(i.y),d=m=>s+(t-s-12)*(m-o)/(l-o),f=m=>n-r-(n-r-10)*(m-c)/(u-c),p=e("svg",{viewBox:`0 0 ${t} ${n}`,class:"xy",role:"img","aria-label":`force from ${xe(c,3)} to ${xe(u,3)} N over deflections from ${xe(o,3)} to ${xe(l,3)} mm`});p.append(e("path",{class:"axis",d:`M${s} 6V${n-r}H${t-8}`}),e("path",{class:"zero",d:`M${d(0)} 6V${n-r}M${s} ${f(0)}H${t-8}`}));for(let m of[o,l])p.append(e("text",{x:d(m),y:n-r+15,"text-anchor":m===o?"start":"end"},xe(m,3)));for(let m of[c,u])p.append(e("text",{x:s-5,y:f(m)+5,"text-anchor":"end"},xe(m,3)));p.append(e("text",{x:(s+t)/2,y:n-6,"text-anchor":"middle"},"deflection, compression positive [mm]"),e("text",{x:13,y:n/2,transform:`rotate(-90 13 ${n/2})`,"text-anchor":"middle"},"force, compression positive [N]"));let g="";i.x.forEach((m,v)=>{g+=`M${d(m).toFixed(1)} ${f(i.y[v]).toFixed(1)}h.01`}),p.append(e("path",{class:"dots",d:g}));let _=h("figure",{});return _.append(p,h("figcaption",{class:"muted"},`${i.count} samples as they would be read`)),_}var Zr=class{constructor(e,t,n={}){this.file=e;this.form=t;Object.assign(this.fields,n,{columns:{...n.columns}});let s=(a,o)=>{let l=h("select",{},h("option",{value:""},"not stated"),...o.map(c=>h("option",c===this.fields[a]?{value:c,selected:!0}:{value:c},`positive in ${c}`)));return l.addEventListener("change",()=>{this.fields[a]=l.value,this.ask()}),l},r=(a,o)=>{let l=h("input",{type:"text",value:this.fields[a],placeholder:o});return l.addEventListener("change",()=>{this.fields[a]=l.value.trim(),this.ask()}),l};this.question=new Ti("Preview",()=>({kind:"preview",files:[this.file],form:this.form,...this.asked()}),a=>this.shown(a.result,a)),this.names.append(...w1.map(a=>h("option",{value:a}))),this.element.append(h("div",{class:"form"},me("Stroke",s("stroke_positive",["compression","extension"])),me("Force",s("force_positive",["compression","tension"])),...t==="recording"?[me("Sample time, where the file has none",r("sample_time","1 ms"))]:[],me("Variable or group (.mat, .tdms)",r("variable","")),this.question.button),h("details",{open:!0},h("summary",{},"Columns"),this.names,h("div",{class:"table",tabindex:"0",role:"region","aria-label":"columns"},h("table",{},h("thead",{},h("tr",{},...["column of the file","unit","from","to","read as","unit, where the file has none"].map(a=>h("th",{scope:"col"},a)))),this.mapping))),this.question.place)}file;form;element=h("div",{class:"reading"});fields={columns:{},variable:"",sample_time:"",stroke_positive:"",force_positive:""};mapping=h("tbody",{});names=h("datalist",{id:"channels-to-read"});question;known=[];asked(){let{columns:e,variable:t,sample_time:n,stroke_positive:s,force_positive:r}=this.fields;return{columns:e,variable:t,stroke_positive:s,force_positive:r,...this.form==="recording"?{sample_time:n}:{}}}ask(){return this.question.ask()}shown(e,t){JSON.stringify(e.columns)!==JSON.stringify(this.known)&&(this.known=e.columns,this.offer());let n=[];if(e.problem&&n.push(h("p",{class:"problem",role:"alert"},mi(e.problem))),n.push(...e.findings.map(s=>h("p",{class:s.severity==="problem"?"problem":"muted"},`${s.severity}: ${mi(s.message)}`))),e.more&&n.push(h("p",{class:"muted"},`and ${e.more} more columns`)),e.points&&n.push(S1(e.points)),e.content){let s=h("div",{});n.push(s),zn.open(JSON.stringify(e.content)).then(r=>{let a=r.content.viewers[0];a&&s.replaceChildren(new vs(a,r).element)})}return[...n,Un(t)]}offer(){let e=Object.fromEntries(Object.entries(this.fields.columns).map(([t,n])=>[n.replace(/ \[[^\]]*\]$/,""),{name:t,unit:/\[([^\]]*)\]$/.exec(n)?.[1]??""}]));this.mapping.replaceChildren(...this.known.map(t=>{let n=e[t.name],s=this.form==="recording"?h("input",{type:"text",list:"channels-to-read",value:n?.name??"",placeholder:"as it is","aria-label":`what ${t.name} is read as`,size:"16"}):h("select",{"aria-label":`what ${t.name} is read as`},...["","displacement","force"].map(o=>h("option",o===(n?.name??"")?{value:o,selected:!0}:{value:o},o||"as it is"))),r=h("input",{type:"text",value:n?.unit??"",placeholder:t.unit||"e.g. mm","aria-label":`unit of ${t.name}`,size:"8"}),a=()=>{for(let[o,l]of Object.entries(this.fields.columns))l.replace(/ \[[^\]]*\]$/,"")===t.name&&delete this.fields.columns[o];s.value&&(this.fields.columns[s.value]=r.value.trim()?`${t.name} [${r.value.trim()}]`:t.name),this.ask()};return s.addEventListener("change",a),r.addEventListener("change",a),h("tr",{},h("th",{scope:"row"},t.name),h("td",{},t.unit||"–"),h("td",{class:"right"},xe(t.least)),h("td",{class:"right"},xe(t.greatest)),h("td",{},s),h("td",{},r))}))}};var Ui=["rig"],et=(i,e={})=>`#/${i}?${new URLSearchParams(e)}`,Bf=null;function yr(i){Bf=i}async function xr(i,e,t,n,s=!1,r=Ui,a={}){let{entries:o}=await Ln(),l=[...o.filter(c=>r.includes(c.kind)).map(c=>c.path),...s?(await Ri()).map(c=>c.name):[]];i.replaceChildren(h("h1",{},t),l.length?h("ul",{},...l.map(c=>h("li",{},h("a",{href:et(e,{[n]:c,...a})},c)))):h("p",{class:"empty"},r===Ui?F("No rig lies here yet: "):F("Nothing of that kind lies here yet: "),h("a",{href:et("project")},F("to the project")),"."))}var rv={label:"Campaign",show:M1};async function M1(i,e){let t=e.get("job"),n=e.get("file");if(t){await L1(i,t);return}if(n){await E1(i,n,e.get("read")??"");return}let{entries:s}=await Ln(),r=s.filter(u=>u.kind==="campaign"),a=h("input",{type:"text",value:"campaign",spellcheck:"false"}),o=h("div",{"aria-live":"polite"}),l=h("button",{type:"submit",class:"main"},"Start from it"),c=h("form",{class:"form"},me("Folder",a),l);c.addEventListener("submit",u=>{u.preventDefault(),l.disabled=!0,Of({kind:"new-campaign",out:a.value}).then(()=>{location.hash=et("campaign",{file:`${a.value}/campaign.toml`})},d=>{o.replaceChildren(vt(d)),l.disabled=!1})}),i.replaceChildren(h("h1",{},"Campaigns"),h("p",{class:"muted"},"From measurements of springs, tyres, decays and trials to a model that holds: characterised, updated, compared with every trial."),r.length?h("ul",{class:"files"},...r.map(u=>h("li",{},h("a",{href:et("campaign",{file:u.path})},u.path)))):h("p",{class:"empty"},"No campaign lies here yet. Start from the one below, and put your own measurements in."),h("h2",{},"Runs"),_r(["campaign"],u=>{location.hash=et("campaign",{job:u.id})},"No campaign was run here yet."),h("h2",{},"A campaign to start from"),h("p",{class:"muted"},"It runs as it is, with synthetic recordings."),c,o)}async function E1(i,e,t){let n=await en(`/api/campaign?${ii({path:e})}`),s=e.includes("/")?e.slice(0,e.lastIndexOf("/")):"",r=_=>s?`${s}/${_}`:_,a=h("input",{type:"text",value:r("results"),spellcheck:"false"}),o=h("input",{type:"checkbox"}),l=h("div",{"aria-live":"polite"}),c=h("button",{type:"button",class:"main"},"Run the campaign");c.addEventListener("click",()=>{$n(c,mr({kind:"campaign",campaign:e,out:a.value,force:o.checked})).then(_=>{location.hash=et("campaign",{job:_.id})},_=>l.replaceChildren(vt(_)))});let u=h("button",{type:"button"},"Check it");u.addEventListener("click",()=>{yp(e).then(({problems:_,notes:m})=>l.replaceChildren(..._.length?_.map(vt):[h("p",{class:"good"},"Nothing is wrong with it.")],...m.map(v=>h("p",{class:"muted"},v))),_=>l.replaceChildren(vt(_)))});let d=h("div",{}),f=(_,m,v={})=>{d.replaceChildren(C1(e,_,m,v,n)),d.scrollIntoView({block:"start"})},p=(_,m,v={})=>{let x=h("button",{type:"button","aria-label":F("look at #",_)},_.split("/").pop());return x.addEventListener("click",()=>f(_,m,v)),x},g=h("input",{type:"text",value:r("measured"),spellcheck:"false"});i.replaceChildren(h("h1",{},n.title),h("p",{class:"muted"},h("a",{href:et("campaign")},"All campaigns"),` · ${e} · rig ${n.rig}`),...n.synthetic?[h("p",{class:"mark fair"},n.synthetic)]:[],h("div",{class:"form"},me("Folder of the results",a),h("label",{class:"field"},h("span",{},"Replace what is there"),o),u,c),l,h("h2",{},"Parts"),...n.bench.length?n.bench.map(_=>T1(_,n,p)):[h("p",{class:"empty"},"Nothing was measured of the parts: the rig is taken as its file says.")],h("h2",{},"Trials"),br("trials",["number","use","road","speed","tyre pressure","recording"],n.trials.map(_=>[String(_.number),String(_.use??"hold-out"),String(_.road??"measured support"),String(_.speed??"–"),String(_.tyre_pressure??"–"),_.file?p(String(_.file),"recording",_):h("span",{class:"mark bad"},`${String(_.recording)} is missing`)])),h("h2",{},"Updates"),n.updates.length?br("updates",["name","free","trials","method"],n.updates.map(_=>[String(_.name),Object.entries(_.free).map(([m,v])=>`${m}: ${Array.isArray(v)?v.join(" … "):String(v)}`).join(", "),JSON.stringify(_.trials??"fit").replaceAll('"',""),String(_.method??"least-squares")])):h("p",{class:"empty"},"Nothing is updated: the campaign compares the characterised model with the trials."),h("h2",{},"Measurements"),h("div",{class:"form"},me("Folder they go to",g)),iu(()=>g.value,"Drop measured files here, or choose them (up to 250 MB each).",_=>f(_[0],"recording")),d),t&&f(t,"recording")}function br(i,e,t,n=[]){let s=r=>n.includes(r)?{class:"right"}:{};return h("div",{class:"table",tabindex:"0",role:"region","aria-label":i},h("table",{},h("thead",{},h("tr",{},...e.map((r,a)=>h("th",{scope:"col",...s(a)},F(r))))),h("tbody",{},...t.map(r=>h("tr",{},...r.map((a,o)=>o?h("td",s(o),a):h("th",{scope:"row"},a)))))))}function T1(i,e,t){let n=i.name==="decay",s=n?"recording":"force-deflection",r=g=>h("input",{type:"text",value:g}),a=r(i.discard_below??""),o=h("select",{},...["linear","polynomial","power","monotone-spline"].map(g=>h("option",g===i.law?{value:g,selected:!0}:{value:g},g))),l=h("select",{},...["drop","shift","keep"].map(g=>h("option",g===i.intercept?{value:g,selected:!0}:{value:g},g))),c=r(e.mass),u=r(i.from??""),d=r(i.to??""),f={files:i.found,columns:i.columns??{},variable:i.variable??"",stroke_positive:i.stroke_positive??""},p=new Ti(n?"Separate damping and friction":"Fit the stiffness",()=>n?{kind:"decay",...f,channel:i.channel??"sprung.z",mass:c.value,begin:u.value,end:d.value,sample_time:i.sample_time??""}:{kind:"stiffness",...f,force_positive:i.force_positive??"",law:o.value,discard_below:a.value,intercept:l.value,branch:i.branch??"loading"},g=>[A1(g.result),_s(g.report,n?"Decay and its bend by friction":"Fit, with the discarded zone"),Un(g)]);return h("section",{class:"job"},h("h3",{},i.name),i.found.length?h("p",{class:"bar"},"measured: ",...i.found.map(g=>t(g,s,i))):h("p",{class:"problem"},`no file is found for ${i.files.join(", ")}`),h("div",{class:"form"},...n?[me("Oscillating mass",c),me("From",u),me("To",d)]:[me("Law",o),me("Ignore smaller deflections",a),me("Force at zero",l)],p.button),p.place)}var sv={stiffness:"N/m",intercept:"N",damping_ratio:"1",damping_coefficient:"N·s/m",coulomb_force:"N",quadratic_drag:"N·s²/m²",natural_frequency_hz:"Hz",equilibrium:"m"};function A1(i){let e=Object.entries(i).flatMap(([n,s])=>{let r=s;return r&&typeof r=="object"&&typeof r.value=="number"&&n in sv?[[n.replaceAll("_"," ").replace(" hz",""),xe(r.value),r.interval?`${xe(r.interval[0])} … ${xe(r.interval[1])}`:"–",sv[n]]]:[]}),t=i.findings??[];return h("div",{},br("estimates",["quantity","value","95 % interval","unit"],e,[1,2]),...t.map(n=>h("p",{class:"muted"},`${n.severity}: ${n.message}`)))}function C1(i,e,t,n,s){let r=h("div",{}),a=h("div",{"aria-live":"polite"}),o=new Zr(e,t,n),c=h("select",{},...[["trial","a trial"],["decay","a free decay"],["spring","the spring"],["tyre","a tyre at a pressure"]].map(([M,b])=>h("option",t==="force-deflection"==(M==="spring")&&(M==="trial"||M==="spring")?{value:M,selected:!0}:{value:M},b))),u=(M,b="")=>h("input",{type:"text",value:M,placeholder:b}),d=u("2 m/s"),f=u("","0.31 MPa"),p=h("select",{},...s.roads.map(M=>h("option",{value:M},M)),h("option",{value:""},"none: the support is measured")),g=u("","its file, with road.z"),_=h("select",{},h("option",{value:"undeformed"},"undeformed springs and tyre"),h("option",{value:"rest"},"the wheel at rest on it")),m=h("select",{},h("option",{value:"hold-out"},"judges only (hold-out)"),h("option",{value:"fit"},"is fitted")),v=h("input",{type:"checkbox"}),x=u("","2 mm"),S=h("span",{class:"sizes"}),y=()=>{let M=c.value==="spring"||c.value==="tyre"?"force-deflection":"recording";M!==o.form&&(o=new Zr(e,M,o.fields),r.replaceChildren(o.element),o.ask()),S.replaceChildren(...c.value==="trial"?[me("Road",p),...p.value?[me("Speed",d)]:[me("File of the support",g),me("Its height counts from",_)],me("Tyre pressure",f),me("Use",m)]:c.value==="decay"?[me("In place of the files there",v)]:[me("In place of the files there",v),...c.value==="tyre"?[me("Pressure",f)]:[],me("Ignore smaller deflections",x)])};c.addEventListener("change",y),p.addEventListener("change",y);let T=h("button",{type:"button",class:"main"},"Enter it into the campaign");return T.addEventListener("click",()=>{let{columns:M,variable:b,sample_time:A,stroke_positive:O,force_positive:N}=o.fields,P={columns:M,variable:b,stroke_positive:O,...c.value==="decay"?{}:{force_positive:N},...o.form==="recording"?{sample_time:A}:{}},k=c.value==="trial"?{recording:e,...p.value?{road:p.value,speed:d.value}:{excitation:{file:g.value,datum:_.value}},tyre_pressure:f.value,use:m.value,...P}:{files:[e],replace:v.checked,...c.value==="tyre"?{pressure:f.value}:{},...c.value==="decay"?{}:{discard_below:x.value},...P};T.disabled=!0,Bn("POST","/api/campaign",{campaign:i,use:c.value,fields:k}).then(()=>{location.hash=et("campaign",{file:i,entered:String(Date.now())})},B=>{a.replaceChildren(vt(B)),T.disabled=!1})}),r.append(o.element),y(),o.ask(),h("section",{class:"job"},h("h3",{},e),r,h("div",{class:"form"},me("It is a measurement of",c),S,T),a)}var R1={holds:"good","holds partly":"fair"},P1=i=>R1[i]??(/not|fail/.test(i)?"bad":"fair");async function L1(i,e){let t=await gr(e),n=await N1(String(t.asked.campaign)),s=h("div",{}),r=h("div",{}),a=new Gs(t),o=!1;i.replaceChildren(h("h1",{},t.title),h("p",{class:"muted"},h("a",{href:et("campaign")},"All campaigns")," · ",h("a",{href:et("campaign",{file:String(t.asked.campaign)})},String(t.asked.campaign))),a.element,r,s);let l=async c=>{if(a.show(c),c.steps?.length&&r.replaceChildren(I1(c.steps,c.state==="running",n)),c.state!=="done"||o)return;o=!0;let u=await gr(e);u.result&&s.replaceChildren(...D1(u.result,n),...u.has_page?[_s(`/api/jobs/${e}/report`,"Report")]:[])};await l(t),vr(i,c=>{let u=c.find(d=>d.id===e);u&&l(u)})}function I1(i,e,t){let n=i[i.length-1],s=i.map(p=>Math.log10(Math.max(p.objective,1e-300))),r=Math.min(...s),a=Math.max(...s,r+1e-9),o=460,l=150,c=document.createElementNS("http://www.w3.org/2000/svg","svg"),u=document.createElementNS("http://www.w3.org/2000/svg","path");c.setAttribute("viewBox",`0 0 ${o} ${l}`),c.setAttribute("class","xy"),c.setAttribute("role","img"),c.setAttribute("aria-label",`objective from ${xe(i[0].objective,4)} to ${xe(n.objective,4)} in ${i.length} evaluations`),u.setAttribute("d",s.map((p,g)=>`${g?"L":"M"}${(8+(o-16)*g/Math.max(1,s.length-1)).toFixed(1)} ${(8+(l-16)*(a-p)/(a-r)).toFixed(1)}`).join("")),u.setAttribute("class","search"),c.append(u);let d=h("figure",{});d.append(c,h("figcaption",{class:"muted"},`objective, logarithmic: ${xe(i[0].objective,4)} at first, ${xe(n.objective,4)} after ${n.evaluation} evaluations`));let f=Object.entries(n.parameters).map(([p,g])=>{let _=(g.value-g.lower)/(g.upper-g.lower||1),{unit:m,factor:v}=t(p);return h("tr",{},h("th",{scope:"row"},p),h("td",{},m),h("td",{class:"right"},xe(g.lower*v)),h("td",{},h("meter",{min:"0",max:"1",value:String(Math.min(1,Math.max(0,_))),"aria-label":`${p} between its bounds`})),h("td",{class:"right"},xe(g.upper*v)),h("td",{class:"right"},xe(g.initial*v)),h("td",{class:"right"},xe(g.value*v,5)),h("td",{},_<.001||_>.999?h("span",{class:"mark fair"},"at its bound"):""))});return h("section",{class:"job"},h("h3",{},e?"The search goes on":"The last search"),d,h("div",{class:"table",tabindex:"0",role:"region","aria-label":"parameters"},h("table",{},h("thead",{},h("tr",{},...["parameter","unit","lower bound","","upper bound","at first","now",""].map((p,g)=>h("th",{scope:"col",...[2,4,5,6].includes(g)?{class:"right"}:{}},p)))),h("tbody",{},...f))))}function D1(i,e){let t=r=>{let a=Object.values(r?.channels??{}).map(o=>o.nrmse).filter(o=>o!==null);return a.length?a.reduce((o,l)=>o+l)/a.length:null},n=[];i.synthetic&&n.push(h("p",{class:"mark fair"},i.synthetic)),n.push(h("h2",{},"Verdicts"),br("verdicts",["trial","use","speed [m/s]","error of the channels (NRMSE)","verdict"],i.trials.map(r=>[String(r.number),r.use,xe(r.speed),Object.entries(r.channels).map(([a,o])=>`${a} ${xe(o.nrmse,3)}`).join(", "),h("span",{class:`mark ${P1(r.verdict)}`},r.verdict)]))),i.characterisation.replaced.length&&n.push(h("h2",{},"Characterised"),br("characterised",["number","unit","in the rig's file","measured","standard error","from"],i.characterisation.replaced.map(r=>{let{unit:a,factor:o}=e(r.path);return[r.path,a,xe(r.described*o),xe(r.measured*o),r.standard_error===null?"–":xe(r.standard_error*o,2),r.source]}),[2,3,4]));for(let r of i.updates)n.push(h("h2",{},`Update: ${r.name}`),h("p",{},`The objective fell by ${xe(r.reduction_percent,3)} %, from ${xe(r.objective_before)} to ${xe(r.objective_after)}, in ${r.evaluations} evaluations on trial ${r.trials.join(", ")}.`),br("parameters",["parameter","unit","at first","value","95 % interval, noise only","bounds","known"],Object.entries(r.parameters).map(([a,o])=>{let l=r.discrepancy?.parameters[a],{unit:c,factor:u}=e(a);return[a,c,xe(o.initial*u),xe(o.value*u,5),o.interval?`${xe(o.interval[0]*u)} … ${xe(o.interval[1]*u)}`:"–",`${xe(o.lower*u)} … ${xe(o.upper*u)}`,o.at_bound?h("span",{class:"mark fair"},"at its bound"):l?.why?h("span",{class:"mark bad"},`not identified: ${l.why}`):l?h("span",{class:"mark good"},"identified"):"–"]}),[2,3,4,5]),h("h3",{},"What the data can tell"),h("p",{class:"muted"},`${r.identifiability.rank} of ${r.identifiability.parameters.length} directions are told apart; the condition is ${xe(r.identifiability.condition,3)}.`),br("identifiability",["unknown","sensitivity","most alike"],r.identifiability.parameters.map((a,o)=>{let l=r.identifiability.correlation[o]??[],c=l.reduce((u,d,f)=>f!==o&&Math.abs(d)>Math.abs(u<0?0:l[u])?f:u,-1);return[a,xe(r.identifiability.sensitivity[o],3),c>=0?`${r.identifiability.parameters[c]} (${xe(l[c],2)})`:"–"]}),[1]),...r.identifiability.findings.map(a=>h("p",{class:"muted"},`${a.place}: ${a.message}`)));let s=[...new Set(i.updates.flatMap(r=>r.comparisons.map(a=>a.number)))];return s.length&&n.push(h("h2",{},"Every update on every trial"),h("p",{class:"muted"},"Mean error of the channels (NRMSE) before and after each update; trials it was fitted on are marked."),br("every update on every trial",["update",...s.map(r=>`trial ${r}`)],i.updates.map(r=>[r.name,...s.map(a=>{let o=r.comparisons.find(l=>l.number===a);return o?`${xe(t(o.before),3)} → ${xe(t(o.after),3)}${o.is_fitted?F(", fitted"):""}${o.after?.verdict?`: ${F(o.after.verdict)}`:""}`:"–"})]))),i.findings.length&&n.push(h("h2",{},"What to be careful about"),h("ul",{},...i.findings.map(r=>h("li",{class:r.severity==="problem"?"problem":""},`${r.place}: ${r.message}`)))),n}async function N1(i){let e=new Map;try{let{rig:t}=await en(`/api/campaign?${ii({path:i})}`),n=i.includes("/")?`${i.slice(0,i.lastIndexOf("/"))}/`:"";for(let s of(await ls(t.endsWith(".toml")?n+t:t)).numbers)e.set(s.path,{unit:s.unit||"–",factor:s.factor})}catch{}return t=>e.get(t)??{unit:"SI",factor:1}}var ov={label:"Inspection",show:U1},k1=[["static_load","static load","N",1],["adhesion","adhesion (EUSAMA)","%",100],["phase_angle_min_deg","least phase angle (EGEA)","°",1],["phase_frequency_hz","at","Hz",1],["relative_force_amplitude","relative force amplitude","%",100],["tyre_rigidity","tyre rigidity","N/mm",.001],["theta_rig","damping ratio on the tester (THETA)","1",1],["theta_road","damping ratio on the road (THETA)","1",1],["boge_amplitude","BOGE amplitude","mm",1e3]],F1={pass:"good",advise:"fair",fail:"bad","not graded":"bad"},zf=i=>h("span",{class:`mark ${F1[i]??"plain"}`},i);async function U1(i,e){let[{entries:t},n,s]=await Promise.all([Ln(),en("/api/choices"),Ri()]),r=t.filter(u=>u.kind==="record").map(u=>u.path),a=t.filter(u=>u.kind==="store").map(u=>u.path),o=[...t.filter(u=>Ui.includes(u.kind)).map(u=>u.path),...s.map(u=>u.name)],l=h("div",{},a.length?av(a,n):h("p",{class:"empty"},"No store lies here yet: name one above (lane.sqlite), and what is evaluated is kept in it.")),c=u=>{u&&!a.includes(u)&&(a.push(u),l.replaceChildren(av(a,n)))};i.replaceChildren(h("h1",{},"Inspection"),h("p",{class:"muted"},"Records of shock-absorber testers: read, evaluated, graded against limits, put on a protocol, and kept in a store."),h("h2",{},"Evaluate a record"),O1(r,o,n,a,e.get("record")??"",c),h("h2",{},"New records"),iu(()=>"records","Drop records of a tester here, or choose them; they go to the folder records.",u=>{location.hash=et("inspection",{record:u[0]})}),h("details",{},h("summary",{},"No record at hand? Simulate a test"),z1(o,n)),h("h2",{},"Store"),l)}var es=(i,e="",t)=>h("select",{},...t===void 0?[]:[h("option",{value:""},F(t))],...i.map(n=>h("option",n===e?{value:n,selected:!0}:{value:n},n)));function O1(i,e,t,n,s,r){if(!i.length)return h("p",{class:"empty"},"No record lies here yet.");let a=es(i,s),o=es(i,"","none"),l=es(t.testers,t.testers.find(y=>y.includes("egea"))),c=es(e,"","not known"),u=es(t.methods,"","that of the tester"),d=(y,T="")=>h("input",{type:"text",value:y,placeholder:T,spellcheck:"false"}),f=d(n[0]??"","lane.sqlite"),p=d("","B-AB 123"),g=d(new Date().toISOString().slice(0,10)),_=d(""),m=h("select",{},h("option",{value:"en"},"English"),h("option",{value:"de"},"Deutsch")),v=h("button",{type:"button"},"Look at the record"),x=h("div",{});v.addEventListener("click",()=>{let y=new Zr(a.value,"recording");x.replaceChildren(y.element),y.ask()});let S=new Ti("Evaluate and grade",()=>({kind:"evaluate",records:[a.value,...o.value?[o.value]:[]],tester:l.value,vehicle:c.value,methods:u.value?[u.value]:[],store:f.value,plate:p.value,date:g.value,inspector:_.value,language:m.value}),y=>(y.result.store&&r(f.value),[...B1(y.result),_s(y.report,"Protocol"),Un(y)]));return h("section",{},h("div",{class:"form"},me("Record of one axle",a),me("Record of the other axle",o),me("Tester",l),me("Method that decides",u),me("Vehicle",c)),h("div",{class:"form"},me("Number plate",p),me("Date",g),me("Inspector",_),me("Language of the protocol",m),me("Keep it in the store",f),v,S.button),x,S.place)}function B1(i){let{wheels:e}=i,t=[];i.error&&t.push(h("p",{class:"problem",role:"alert"},i.error.message)),t.push(h("p",{class:"bar"},"verdict: ",zf(i.verdict),h("span",{class:"muted"},`${i.deciding.join(", ")} decides; limits: ${i.limits.label}`),...i.store?[h("span",{class:"good"},`kept in the store as record ${i.store.records.join(", ")}`)]:[]));let n=k1.filter(([l])=>e.some(c=>typeof c[l]=="number")),s=l=>[l.axle,l.wheel].filter(Boolean).map(c=>F(c)).join(" "),r=(l,c,u)=>{let d=l[c],f=l.uncertainty?.[c];return typeof d=="number"?`${xe(d*u)}${f?` ± ${xe(f*u,1)}`:""}`:"–"},a=[...new Set(e.flatMap(l=>Object.keys(l.grade)))];t.push(h("div",{class:"table",tabindex:"0",role:"region","aria-label":"wheels"},h("table",{},h("thead",{},h("tr",{},h("th",{scope:"col"},"wheel"),...e.map(l=>h("th",{scope:"col",class:"right"},s(l))),h("th",{scope:"col"},"unit"))),h("tbody",{},h("tr",{},h("th",{scope:"row"},F("verdict")),...e.map(l=>h("td",{class:"right"},zf(l.verdict))),h("td",{})),...n.map(([l,c,u,d])=>h("tr",{},h("th",{scope:"row"},F(c)),...e.map(f=>h("td",{class:"right"},r(f,l,d))),h("td",{},u))),...a.map(l=>h("tr",{},h("th",{scope:"row"},F("grade #",l.toUpperCase())),...e.map(c=>h("td",{class:"right"},c.grade[l]??"–")),h("td",{})))))));let o=[...e.flatMap(l=>l.reasons.map(c=>`${s(l)}: ${c}`)),...i.axle?.reasons??[],...e.flatMap(l=>l.findings.map(c=>`${s(l)}, ${c.severity}: ${c.message}`)),...(i.findings??[]).map(l=>`${l.severity}: ${l.message}`)];return t.push(h("details",{},h("summary",{},`Why (${o.length})`),h("ul",{},...o.map(l=>h("li",{},l))))),t}function z1(i,e){let t=es(i,i.find(l=>l==="audi-a6-half-car-4dof")),n=es(e.testers,e.testers.find(l=>l.includes("egea"))),s=h("input",{type:"text",value:"",placeholder:"0.4"}),r=es(["both","left","right"],"both"),a=h("input",{type:"text",value:"simulated.csv",spellcheck:"false"}),o=new Ti("Simulate the test",()=>({kind:"test",vehicle:t.value,tester:n.value,wear:s.value,wheel:r.value,out:a.value}),l=>[h("p",{class:"good"},`${a.value} was written. `,h("a",{href:et("inspection",{record:a.value})},"Evaluate it")),Un(l)]);return h("section",{},h("div",{class:"form"},me("Rig or vehicle",t),me("Tester",n),me("Loss of damping",s),me("Wheel",r),me("Record",a),o.button),o.place)}function av(i,e){let t=es(i),n=d=>h("input",{type:"text",placeholder:d,spellcheck:"false"}),s=n("B-AB*"),r=es(["pass","advise","fail","not graded"],"","any"),a=es(e.testers,"","any"),o=n("2026-01-31"),l=n("2026-12-31"),c=h("div",{"aria-live":"polite"}),u=new Ti("Search",()=>({kind:"search",store:t.value,plate:s.value,verdict:r.value,tester:a.value,since:o.value,until:l.value}),d=>{let{records:f}=d.result;if(!f.length)return[h("p",{class:"empty"},"No record fits."),Un(d)];let p=f.map(g=>{let _=h("button",{type:"button","aria-label":`history of ${g.plate}`},F("history"));return _.addEventListener("click",()=>{let m=new Ti("Again",()=>({kind:"history",store:t.value,plate:g.plate}),v=>[h("h3",{},`History of ${v.result.plate}`),...V1(v.result.trends),_s(v.report,"Every visit"),Un(v)]);c.replaceChildren(m.place),m.ask()}),h("tr",{},h("th",{scope:"row"},String(g.number)),...[g.date,g.plate,g.vehicle,g.axle,g.tester,g.name].map(m=>h("td",{},m||"–")),h("td",{},g.verdict?zf(g.verdict):"–"),h("td",{},...g.plate?[_]:[]))});return[h("div",{class:"table",tabindex:"0",role:"region","aria-label":"records"},h("table",{},h("caption",{},`${f.length} record${f.length===1?"":"s"}`),h("thead",{},h("tr",{},...["record","date","plate","vehicle","axle","tester","file","verdict",""].map(g=>h("th",{scope:"col"},g)))),h("tbody",{},...p))),Un(d)]});return h("section",{},h("div",{class:"form"},me("Store",t),me("Number plate, or a pattern",s),me("Verdict",r),me("Tester",a),me("First day",o),me("Last day",l),u.button),u.place,c)}function V1(i){return i.length?[h("div",{class:"table",tabindex:"0",role:"region","aria-label":"change per year"},h("table",{},h("caption",{},"Change per year"),h("thead",{},h("tr",{},...["axle","wheel","value","change per year","visits"].map(e=>h("th",{scope:"col"},e)))),h("tbody",{},...i.map(e=>h("tr",{},h("th",{scope:"row"},e.axle||"–"),h("td",{},e.wheel),h("td",{},e.quantity),h("td",{class:"right"},xe(e.change_per_year,3)),h("td",{class:"right"},String(e.visits)))))))]:[h("p",{class:"muted"},"One visit tells no trend.")]}var lv={label:"Jobs",show:W1},G1={sweep:"studies",campaign:"campaign",compare:"ride",pareto:"ride",design:"kinematics",evaluate:"inspection"};function H1(i){let e=G1[i.kind];e&&e!=="kinematics"?location.hash=et(e,{job:i.id}):window.open(`/api/jobs/${encodeURIComponent(i.id)}/report`,"_blank","noopener")}async function W1(i){i.replaceChildren(h("h1",{},"Jobs"),h("p",{class:"muted"},"Long work goes on when this page is closed, and when the server is ended: it is found again here."),_r(null,H1,"No long work was begun here yet. Studies, campaigns, rides and designs begin it."))}var $1=i=>en(`/api/jobs/${encodeURIComponent(i)}`);function cv(i,e,t,n,s){let r=[...new Set(e.numbers.map(({path:g})=>/^(hardpoints\.\w+)\[/.exec(g)?.[1]).filter(g=>!!g&&!g.endsWith("wheel_centre")))],a=r.map(g=>h("input",{type:"checkbox",value:g,checked:/tie_rod|link_5/.test(g)})),o=h("input",{type:"text",value:"15 mm"}),l=h("input",{type:"number",min:"1",max:"100",value:"4"}),c=h("div",{"aria-live":"polite"}),u=h("button",{type:"submit",class:"main"},F("Search")),d=h("form",{},h("fieldset",{class:"free"},h("legend",{},F("Hardpoints that may move")),...a.map((g,_)=>h("label",{},g,` ${r[_].replace("hardpoints.","").replaceAll("_"," ")}`))),h("div",{class:"form"},me(F("Each coordinate by up to"),o),me(F("Searches"),l),u));d.addEventListener("submit",g=>{g.preventDefault();let _=a.filter(m=>m.checked).map(m=>m.value);if(!t.length||!_.length){c.replaceChildren(h("p",{class:"muted"},F("Add a target above, and choose a hardpoint that may move.")));return}u.disabled=!0,f(_).catch(m=>c.replaceChildren(vt(m))).finally(()=>{u.disabled=!1})});async function f(g){let _=i.replace(/\.toml$/,"").replaceAll("/","-"),m=new Date().toISOString().replace(/\D/g,"").slice(2,14),v=`designs/${_}-${m}.toml`,x=P=>JSON.stringify(P),S=await Er(i),y=await Gi(i,S.text,[],n.changes);if(y.problems.length)throw new Error(y.problems.map(P=>`${P.path?`${P.path}: `:""}${P.text}`).join(" "));let T=`designs/${_}-${m}-start.toml`;await Tr(T,y.text,"");let M=['schema = "jounce.design/1"',`rig = ${x(`${_}-${m}-start.toml`)}`,`starts = ${Number(l.value)||4}`,"",...g.flatMap(P=>["[[free]]",`point = ${x(P)}`,`within = ${x(o.value)}`,""]),...t.flatMap(P=>["[[target]]",...Object.entries(P).map(([k,B])=>`${k} = ${x(String(B))}`),""])].join(`
`);await Tr(v,M,"");let b=await(await Bn("POST","/api/jobs",{kind:"design",study:v,out:`designs/${_}-${m}`})).json(),A=h("progress",{max:"1","aria-label":F("share done")}),O=h("span",{}),N=h("button",{type:"button"},F("Cancel"));for(N.addEventListener("click",()=>{Bn("POST",`/api/jobs/${encodeURIComponent(b.id)}/cancel`,{})}),c.replaceChildren(h("p",{class:"bar"},A,O,N));;){let P=await $1(b.id);if(!c.isConnected)return;if(P.share===null?A.removeAttribute("value"):A.value=P.share,O.textContent=[P.said,`${xe(Date.now()/1e3-P.begun,2)} s`,P.left?F("# s left",xe(P.left,2)):""].filter(Boolean).join(", "),P.state==="done"){p(P);return}if(!["running","cancelling"].includes(P.state)){c.replaceChildren(vt(new Error(P.error??F("The search was ended."))));return}await new Promise(k=>setTimeout(k,400))}}function p(g){let _=g.result,m=h("button",{type:"button",class:"main"},F("Take the best"));m.addEventListener("click",()=>s(Object.fromEntries(Object.entries(_.moved).map(([S,y])=>[S,y.after]))));let v=(S,y)=>{if(!Object.keys(y).length)return"";let T=h("button",{type:"button","aria-label":F("Take the design of search #",String(S))},F("Take"));return T.addEventListener("click",()=>s(y)),T},x=new Map(e.numbers.map(S=>[S.path,S]));c.replaceChildren(h("p",{class:_.met?"good":"problem"},_.met?F("Every target is met."):F("# of the targets are missed.",String(_.targets.filter(S=>!S.met).length))),h("div",{class:"table",tabindex:"0",role:"region","aria-label":F("searches")},h("table",{},h("thead",{},h("tr",{},...[F("search"),F("targets"),F("cost, tolerances²"),F("moved, share of the boxes"),F("ended"),""].map(S=>h("th",{scope:"col"},S)))),h("tbody",{},..._.starts.map(S=>h("tr",{},h("th",{scope:"row"},String(S.start)),h("td",{},S.met?F("met"):F("missed")),h("td",{class:"right"},xe(S.cost,3)),h("td",{class:"right"},xe(S.travelled,2)),h("td",{},S.ended),h("td",{},v(S.start,S.numbers))))))),h("div",{class:"table",tabindex:"0",role:"region","aria-label":F("what was moved")},h("table",{},h("thead",{},h("tr",{},...[F("number"),F("before"),F("after"),F("unit")].map(S=>h("th",{scope:"col"},S)))),h("tbody",{},...Object.entries(_.moved).map(([S,y])=>{let T=x.get(S),M=T?.factor??1;return h("tr",{},h("th",{scope:"row"},S),h("td",{class:"right"},xe(y.before*M,5)),h("td",{class:"right"},xe(y.after*M,5)),h("td",{},T?.unit??""))})))),h("p",{class:"bar"},m,h("a",{href:`/api/jobs/${g.id}/report`,target:"_blank"},F("Its report"))))}return h("div",{},d,c)}var Hs=46,Sl=8,hv=6,X1=16,su=104,ru=class{constructor(e){this.moved=e;new ResizeObserver(()=>this.sized()).observe(this.element),jn(()=>{this.colours={},this.draw()})}moved;element=h("div",{class:"multiples"});plots=[];x=[];kind="";wanted="";width=0;place=0;colours={};show(e,t,n){let s=e.scenes[0],r=s.panes.filter(o=>!o.name.startsWith("Δ"));this.x=t.get(s.x);let a=JSON.stringify([r.map(o=>[o.name,o.unit])]);a!==this.kind&&(this.kind=a,this.plots=r.map(o=>this.made(o.name,o.words,o.unit)),this.element.replaceChildren(...this.plots.map(o=>o.box)),this.filter(this.wanted)),r.forEach((o,l)=>{let c=this.plots[l];c.lines=o.curves.map(({role:u,y:d})=>({role:u,y:t.get(d)})),c.band=n.find(u=>u.quantity===o.name)??null,c.box.classList.toggle("wanted",c.band!==null)}),this.width?this.draw():this.sized(),this.mark(this.place)}filter(e){this.wanted=e;let t=e.toLowerCase().split(/\s+/).filter(Boolean);for(let n of this.plots)n.box.hidden=!t.every(s=>n.box.dataset.words.includes(s));this.draw()}mark(e){this.place=e;let[t,n]=this.ends(),s=n>t?(e-t)/(n-t):0,r=Hs+Math.min(Math.max(s,0),1)*(this.width-Hs-Sl);for(let a of this.plots){if(a.box.hidden)continue;a.mark.style.transform=`translateX(${r}px)`;let o=a.lines[0];a.value.textContent=o?xe(Li(this.x,o.y,e),4):"–"}}ends(){return this.x.length?[this.x[0],this.x[this.x.length-1]]:[0,1]}made(e,t,n){let s=h("canvas",{"aria-hidden":"true"}),r=h("output",{},"–"),a=h("i",{class:"at"}),o=h("span",{class:"verdict"}),l=h("div",{class:"holder"},s,a);l.addEventListener("pointermove",u=>{let[d,f]=this.ends(),p=l.getBoundingClientRect();this.moved(d+Math.min(Math.max((u.clientX-p.left-Hs)/(p.width-Hs-Sl),0),1)*(f-d))});let c=h("figure",{"data-words":`${e} ${t}`.toLowerCase().replaceAll("_"," ")},h("figcaption",{title:t},h("b",{},e.replaceAll("_"," "))," ",r,h("span",{class:"unit"},` ${n||"–"}`),o),l);return{name:e,lines:[],band:null,canvas:s,value:r,mark:a,box:c,verdict:o}}sized(){let e=this.plots.find(n=>!n.box.hidden),t=e?Math.floor(e.box.clientWidth):0;if(!(t<60)){this.width=t;for(let{canvas:n}of this.plots)n.width=t,n.height=su;this.draw(),this.mark(this.place)}}ink(e){return this.colours[e]??=xt(e)}draw(){if(this.width)for(let e of this.plots)e.box.hidden||this.drawn(e)}drawn(e){let t=e.canvas.getContext("2d",{willReadFrequently:!0}),{x:n,width:s}=this,[r,a]=this.ends(),o=1/0,l=-1/0,c=g=>{g!==null&&Number.isFinite(g)&&(g<o&&(o=g),g>l&&(l=g))};for(let{y:g}of e.lines)for(let _=0;_<g.length;_++)c(g[_]);e.band?.low.forEach(c),e.band?.high.forEach(c),l>=o||([o,l]=[-1,1]);let u=1e-6*Math.max(Math.abs(o),Math.abs(l))||1e-9,d=l-o>u?.08*(l-o):.1*Math.abs(l)||1;o-=d,l+=d;let f=g=>Hs+(g-r)/(a-r||1)*(s-Hs-Sl),p=g=>hv+(l-g)/(l-o)*(su-hv-X1);t.clearRect(0,0,s,su),t.font="11px system-ui, sans-serif",t.lineWidth=1,t.strokeStyle=this.ink("line"),t.fillStyle=this.ink("muted"),t.textAlign="right",t.textBaseline="middle";for(let g of so(o,l,3)){let _=Math.round(p(g))+.5;t.beginPath(),t.moveTo(Hs,_),t.lineTo(s-Sl,_),t.stroke(),t.fillText(Ml(g),Hs-5,_)}t.textBaseline="alphabetic",t.textAlign="center";for(let g of so(r,a,3))t.fillText(Ml(g),Math.min(Math.max(f(g),Hs+8),s-Sl-8),su-4);e.band?this.band(t,e,f,p,o,l):e.verdict.textContent="";for(let g=e.lines.length-1;g>=0;g--){let{role:_,y:m}=e.lines[g];t.strokeStyle=this.ink(_),t.lineWidth=g?1.25:2,t.setLineDash(g?[5,3]:[]),t.beginPath();let v=!1;for(let x=0;x<n.length;x++){let S=m[x];if(S==null||!Number.isFinite(S)){v=!1;continue}v?t.lineTo(f(n[x]),p(S)):t.moveTo(f(n[x]),p(S)),v=!0}t.stroke()}t.setLineDash([])}band(e,t,n,s,r,a){let o=t.band,l=o.at.length>1?0:4;e.fillStyle=this.ink("span"),e.strokeStyle=this.ink("other-1"),e.beginPath();let c=[...o.at.map((_,m)=>[n(_),s(o.high[m]??a)]),...o.at.map((_,m)=>[n(_),s(o.low[m]??r)]).reverse()];l?e.rect(c[0][0]-l,c[0][1],2*l,c[1][1]-c[0][1]):(c.forEach(([_,m],v)=>{v?e.lineTo(_,m):e.moveTo(_,m)}),e.closePath()),e.fill(),e.stroke();let u=t.lines[0]?.y,[d,f]=this.ends(),p=1e-9*(f-d);if(o.at.some(_=>_<d-p||_>f+p)){t.verdict.textContent=" ?",t.verdict.className="verdict",t.verdict.title=F("not swept as far as this is wanted");return}let g=!!u&&o.at.every((_,m)=>{let v=Li(this.x,u,_);return v>=(o.low[m]??-1/0)-1e-9&&v<=(o.high[m]??1/0)+1e-9});t.verdict.textContent=g?" ✓":" ✗",t.verdict.className=`verdict ${g?"good":"missed"}`,t.verdict.title=F(g?"within the tolerance":"outside of the tolerance")}};function so(i,e,t){let n=(e-i)/t,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(o=>o*s).find(o=>o>=n),a=[];for(let o=Math.ceil(i/r);o*r<=e+1e-9*r;o++)a.push(o*r);return a.length<2&&t<6?so(i,e,t+1):a}function Ml(i){let e=Number(i.toPrecision(4));return fi(Math.abs(e)>=1e5||e!==0&&Math.abs(e)<.001?e.toExponential(0):String(e))}var uv=.001,ro=class{constructor(e,t){this.view=e;this.moved=t;let n=h("select",{},...[["view",F("in the plane of the picture")],["x",F("along x")],["y",F("along y")],["z",F("along z")]].map(([s,r])=>h("option",{value:s},r)));n.addEventListener("change",()=>{e.way=n.value}),e.grabbed=(s,r,a)=>this.drag(s,r,a),this.choice.addEventListener("change",()=>this.choose(this.choice.value)),this.inputs.forEach(s=>{s.addEventListener("change",()=>{let r=this.inputs.map(a=>Number(a.value));this.inputs.some(a=>a.value==="")||!r.every(Number.isFinite)||this.put(this.choice.value,r,!0)})}),this.element.append(me(F("Hardpoint"),this.choice),...this.inputs.map((s,r)=>me(`${"xyz"[r]} [mm]`,s)),me(F("Dragged"),n),me(F("Snaps to"),this.snap))}view;moved;element=h("div",{class:"points form"});choice=h("select",{"aria-label":F("Hardpoint")});inputs=["x","y","z"].map(e=>h("input",{type:"number",step:"any","aria-label":`${e} [mm]`}));snap=h("select",{},...["0.1","0.5","1","5","10"].map(e=>h("option",{value:e,...e==="1"?{selected:!0}:{}},`${e} mm`)));places=new Map;from=null;set(e){let t=new Map;for(let{path:n,value:s}of e){let r=/^hardpoints\.(\w+)\[([012])\]$/.exec(n);if(!r)continue;let a=t.get(r[1])??[0,0,0];a[Number(r[2])]=s/uv,t.set(r[1],a)}[...t.keys()].join()!==[...this.places.keys()].join()&&this.choice.replaceChildren(...[...t.keys()].map(n=>h("option",{value:n},n.replaceAll("_"," ")))),this.places=t,this.write()}choose(e){this.choice.value=e,this.view.choose(e),this.write()}drag(e,t,n){let s=this.places.get(e);if(!s)return;(this.from===null||this.choice.value!==e)&&(this.from=[...s],this.choose(e));let r=Math.hypot(...t),a=Number(this.snap.value),l=this.from.map((c,u)=>Math.abs(t[u])>.02*r?Math.round((c+t[u])/a)*a:c);n&&(this.from=null),(r>0||n)&&this.put(e,l,n)}put(e,t,n){let s=this.places.get(e),r={};t.forEach((a,o)=>{(n||Math.abs(a-s[o])>1e-9)&&(r[`hardpoints.${e}[${o}]`]=Number((a*uv).toPrecision(12)))}),this.places.set(e,t),this.write(),Object.keys(r).length&&this.moved(r,n)}write(){let e=this.places.get(this.choice.value);this.inputs.forEach((t,n)=>{document.activeElement!==t&&(t.value=e?String(Number(e[n].toFixed(4))):"")})}};var dv={label:"Kinematics",show:q1},El=class{constructor(e,t,n,s,r,a){this.name=e;this.words=t;this.unit=n;this.range.value=`${-s} ${n}:${s} ${n}:${r} ${n}`,this.slider.min=String(-s),this.slider.max=String(s),this.slider.value="0",this.slider.setAttribute("aria-label",`${t} [${n}]`),this.number.setAttribute("aria-label",`${t} [${n}], ${F("typed")}`),this.range.setAttribute("aria-label",`${t}: ${F("first:last:step")}`),this.slider.addEventListener("input",()=>{this.number.value=String(Number(Number(this.slider.value).toPrecision(4))),a(!1)}),this.number.addEventListener("input",()=>{this.number.value!==""&&(this.slider.value=this.number.value,a(!1))}),this.range.addEventListener("change",()=>{let[o,l]=this.range.value.split(":").map(c=>parseFloat(c));Number.isFinite(o)&&Number.isFinite(l)&&(this.slider.min=String(o),this.slider.max=String(l)),a(!0)}),this.element=h("div",{class:"slider drive"},h("span",{class:"name"},t),this.slider,this.number,h("span",{class:"unit"},n),this.range)}name;words;unit;slider=h("input",{type:"range",step:"any"});number=h("input",{type:"number",step:"any",value:"0"});range=h("input",{type:"text",spellcheck:"false"});element;get value(){return Number(this.number.value)||0}set value(e){this.slider.value=String(e),this.number.value=String(Number(e.toPrecision(4)))}swept(e,t){this.range.hidden=!e,this.slider.disabled=this.number.disabled=!t,this.element.classList.toggle("unused",!t)}};async function q1(i,e){let t=e.get("rig");if(!t){await xr(i,"kinematics",F("Kinematics"),"rig",!0);return}let[n,{entries:s},r]=await Promise.all([ls(t),Ln(),Ri()]);if(!n.spatial){i.replaceChildren(h("h1",{},t),h("p",{class:"empty"},F("This rig has no hardpoints, and so no kinematics: "),h("a",{href:et("kinematics")},F("choose another one")),"."));return}let a=t.endsWith(".toml"),o=n.numbers.some(he=>he.path==="wheel.radius"&&he.value<.18),l=n.numbers.some(he=>/^hardpoints\.(tie_rod|link_5)_inner\[0\]$/.test(he.path)),c=o?20:50,u=new Vs,d=[];yr({times:d});let f=h("p",{class:"state",role:"status"}),p=h("div",{}),g=new bl,_=h("select",{},...[["travel",F("wheel travel")],...l?[["rack",F("rack travel")]]:[],["roll",F("roll of the body")]].map(([he,Ie])=>h("option",{value:he},Ie))),m=(he,Ie)=>{Ie===_.value&&!he?L():Q()},v={travel:new El("travel",F("Wheel travel, bump positive"),"mm",c,c/10,he=>m(he,"travel")),rack:new El("rack",F("Rack travel, to the left positive"),"mm",o?10:20,o?1:2,he=>m(he,"rack")),roll:new El("roll",F("Roll, left side up positive"),"deg",4,.5,he=>m(he,"roll"))},x=()=>{let he=_.value;v.travel.swept(he==="travel",he!=="roll"),v.rack.swept(he==="rack",l),v.roll.swept(he==="roll",he==="roll")};_.addEventListener("change",()=>{x(),Q()});let S=s.filter(he=>Ui.includes(he.kind)&&he.path!==t).map(he=>he.path),y=a?await _p(t):[],T=h("select",{},h("option",{value:""},F("nothing else")),...y.length?[h("optgroup",{label:F("earlier versions")},...y.map(he=>h("option",{value:he.name},`${F("replaced")} ${new Date(he.replaced*1e3).toISOString().slice(0,16).replace("T"," ")} UTC`)))]:[],...S.length?[h("optgroup",{label:F("this project")},...S.map(he=>h("option",{value:he},he)))]:[],h("optgroup",{label:F("shipped")},...r.map(he=>h("option",{value:he.name},he.name))));T.addEventListener("change",()=>{Q()});let M=new dr(!0),b=h("div",{class:"player bare"},M.element),A=null,O=!0,N=1,P={low:0,high:0},k=pi(F("centres"),!0,he=>{O=he,M.showCentres(he?A:null)},F("instant centres in front and side view, and the roll centre"));M.element.querySelector(".bar").append(h("div",{class:"group"},k));let B=new ru(he=>{v[_.value].value=he,L()}),L=()=>{let he=v[_.value],Ie=Math.min(Math.max(he.value,P.low),P.high);M.set({body:0,travel:Ie*N,ground:H(Ie*N),load:1,time:0,roll:_.value==="roll"?Ie*Math.PI/180:0}),B.mark(Ie)},H=he=>0,Y=n.numbers.map(he=>he.path).filter(he=>/ball_joint\[2\]|tie_rod_(inner|outer)\[2\]/.test(he)).slice(0,4),$=new to(n,Y,()=>{K.set(ce()),Q()}),ce=()=>n.numbers.map(({path:he,value:Ie})=>({path:he,value:$.changes[he]??Ie})),K=new ro(M,he=>{for(let[Ie,rt]of Object.entries(he))$.set(Ie,rt);Q()});K.set(n.numbers);let ee=[],ne=h("select",{},h("option",{value:""},F("none")),...s.filter(he=>he.kind==="design").map(he=>h("option",{value:he.path},he.path)));ne.addEventListener("change",()=>{Q()});let ue=[],de=new Vf(ee,()=>ue,()=>_.value,()=>{Q()}),Q=()=>u.ask(async()=>{let he=performance.now(),Ie=_.value,rt=qe=>qe.name===Ie?qe.range.value:qe.value?`${qe.value} ${qe.unit}`:"",dt=setTimeout(()=>{f.textContent=F("computing; the first time a model is compiled once, which takes some seconds")},500);try{let qe=zn.of(await da("kinematics",{rig:t,changes:$.changes,over:Ie,against:T.value,targets:ee,study:ne.value,travel:Ie==="roll"?"":rt(v.travel),rack:l?rt(v.rack):"",roll:Ie==="roll"?rt(v.roll):""}));if(!i.isConnected)return;let Ft=qe.content,Rt=qe.content.viewers[0],Wt=Rt.scenes[0],Tt=qe.get(Wt.x);if(A=Ft.centres,P={low:Tt[0],high:Tt[Tt.length-1]},Wt.motion){let Dt=qe.content.mechanisms[Wt.motion.mechanism],ut=Dt.travel;N=Math.abs(P.high)>0?ut[ut.length-1]/P.high:P.low!==0?ut[0]/P.low:1,H=nn=>Dt.contact[Y1(ut,nn)]?.[2]??0,M.show(Dt,Wt.motion),M.showCentres(O?A:null)}ue=Wt.panes.filter(Dt=>!Dt.name.startsWith("Δ")).map(({name:Dt,unit:ut})=>({name:Dt,unit:ut})),de.offer(),B.show(Rt,qe,Ft.targets),L(),p.replaceChildren(...Ft.notes.map(Dt=>h("p",{class:"muted"},Dt))),ge.replaceChildren(...(Rt.roles.length>1?Rt.roles:[]).map(({role:Dt,label:ut},nn)=>h("li",{},h("i",{class:`swatch ${Dt}`}),ut,nn?` (${F("dashed")})`:""))),g.show(Ft),M.draw(),d.push(performance.now()-he),f.textContent=F("# curves computed and drawn",String(ue.length))+` ${F("in")} ${xe(d[d.length-1],2)} ms`,f.classList.remove("problem")}catch(qe){f.textContent=qe instanceof Error?qe.message:String(qe),f.classList.add("problem")}finally{clearTimeout(dt)}}),ge=h("ul",{class:"legend"}),ye=h("input",{type:"search",placeholder:F("camber, roll centre …")});ye.addEventListener("input",()=>B.filter(ye.value));let Te=h("button",{type:"button"},F("Write these changes into the file")),be=h("span",{"aria-live":"polite"});Te.addEventListener("click",()=>{if(!Object.keys($.changes).length){be.textContent=F("Nothing is changed.");return}$n(Te,(async()=>{try{let he=await Er(t),Ie=await Gi(t,he.text,[],$.changes);if(Ie.problems.length)throw new Error(Ie.problems[0].text);await Tr(t,Ie.text,he.digest),sessionStorage.setItem("written",F("The changes stand in the file; what it was before is an earlier version.")),dispatchEvent(new HashChangeEvent("hashchange"))}catch(he){be.replaceChildren(vt(he))}})())});let Ye=a?cv(t,n,ee,$,he=>{for(let[Ie,rt]of Object.entries(he))$.set(Ie,rt);K.set(ce()),Q()}):h("p",{class:"muted"},F("Start a rig of your own from this one to design it."));jn(()=>M.repaint()),x(),i.replaceChildren(h("h1",{},F("Kinematics of #",t)),...a?[h("p",{class:"bar"},h("a",{href:et("rig",{name:t})},F("To its file")))]:[],h("div",{class:"form"},me(F("Curves over"),_),me(F("Compare with"),T),me(F("Targets of a study"),ne),me(F("Show curves with"),ye)),h("div",{class:"sliders drives"},...["travel",...l?["rack"]:[],"roll"].map(he=>v[he].element)),f,p,h("div",{class:"beside"},h("div",{class:"stuck"},b,K.element),h("div",{},ge,h("div",{class:"scrolled",tabindex:"0",role:"region","aria-label":F("curves")},B.element))),h("h2",{},F("Numbers")),$.element,...a?[h("p",{class:"bar"},Te,be)]:[],h("h2",{},F("Targets")),de.element,h("h2",{},F("Design from targets")),Ye,g.element),be.textContent=sessionStorage.getItem("written")??"",sessionStorage.removeItem("written"),await Q()}function Y1(i,e){let t=0;return i.forEach((n,s)=>{Math.abs(n-e)<Math.abs(i[t]-e)&&(t=s)}),t}var Vf=class{constructor(e,t,n,s){this.targets=e;this.quantities=t;this.changed=s;let r=h("select",{},...[["value","="],["at_least","≥"],["at_most","≤"]].map(([d,f])=>h("option",{value:d,title:d},f))),a=h("input",{type:"text",value:"0 deg"}),o=h("input",{type:"text",value:"0.1 deg"}),l=h("input",{type:"text",value:"-20 mm:20 mm:10 mm"}),c=()=>{let d=this.quantities().find(f=>f.name===this.quantity.value);if(d){let f=d.unit.replace("°","deg");a.value=`0 ${f}`.trim(),o.value=`0.1 ${f}`.trim()}};this.quantity.addEventListener("change",c);let u=h("form",{class:"form"},me(F("Quantity"),this.quantity),me(F("is wanted"),r),me(F("Value"),a),me(F("Tolerance"),o),me(F("At, or over first:last:step"),l),h("button",{type:"submit"},F("Add the target")));u.addEventListener("submit",d=>{d.preventDefault(),e.push({quantity:this.quantity.value,[r.value]:a.value,tolerance:o.value,...l.value.includes(":")?{over:l.value}:l.value?{at:l.value}:{},...l.value&&n()==="rack"?{along:"rack"}:{}}),this.list(),s()}),this.element.append(h("div",{class:"table"},h("table",{},this.rows)),u),this.list()}targets;quantities;changed;element=h("div",{});quantity=h("select",{});rows=h("tbody",{});known="";offer(){let e=this.quantities().map(n=>n.name);if(e.join()===this.known)return;this.known=e.join();let t=this.quantity.value;this.quantity.replaceChildren(...e.map(n=>h("option",{value:n},n.replaceAll("_"," ")))),e.includes(t)&&(this.quantity.value=t)}list(){this.rows.replaceChildren(...this.targets.length?this.targets.map((e,t)=>h("tr",{},h("th",{scope:"row"},e.quantity.replaceAll("_"," ")),h("td",{},e.value!==void 0?`= ${e.value} ± ${e.tolerance}`:e.at_least!==void 0?`≥ ${e.at_least} − ${e.tolerance}`:`≤ ${e.at_most} + ${e.tolerance}`),h("td",{},`${e.over??e.at??F("at design")}${e.along?` (${F("rack travel")})`:""}`),h("td",{},h("button",{type:"button","aria-label":F("Take # away",e.quantity),click:()=>{this.targets.splice(t,1),this.list(),this.changed()}},"×")))):[h("tr",{},h("td",{class:"muted"},F("None yet: add one below, and its band stands in its curve.")))])}};var fv={label:"Project",show:K1},Z1={rig:[["rig","name","edit"],["trial","rig","drive it"],["kinematics","rig","kinematics"]],record:[["record","path","look at it"],["trial","record","beside a run"],["inspection","record","inspect"]],campaign:[["campaign","file","open"]],store:[["inspection","store","search"]]},pv=i=>new Date(i*1e3).toISOString().slice(0,16).replace("T"," ");async function K1(i){let[{name:e,folder:t,entries:n},s,r]=await Promise.all([Ln(),Ri(),en("/api/history")]);document.getElementById("project").textContent=e;let a=n.map(f=>{let p=Z1[f.kind]??[],[g]=p,_=f.kind==="page"&&f.path.endsWith(".html")?`/api/document?${ii({path:f.path})}`:null;return h("tr",{},h("th",{scope:"row"},g?h("a",{href:et(g[0],{[g[1]]:f.path})},f.path):_?h("a",{href:_,target:"_blank"},f.path):f.path),h("td",{},F(f.kind)),h("td",{class:"right"},`${xe(f.size/1e3,3)} kB`),h("td",{},pv(f.modified)),h("td",{class:"links"},...p.slice(1).flatMap(([m,v,x])=>[h("a",{href:et(m,{[v]:f.path})},F(x))," "])))}),o=h("select",{},...s.map(f=>h("option",{value:f.name},f.name))),l=h("input",{type:"text",value:`${s[0]?.name??"rig"}.toml`,spellcheck:"false"});o.addEventListener("change",()=>{l.value=`${o.value}.toml`});let c=h("div",{"aria-live":"polite"}),u=h("button",{type:"submit",class:"main"},F("Copy it here")),d=h("form",{class:"form"},me(F("Shipped rig"),o),me(F("Name of your file"),l),u);d.addEventListener("submit",f=>{f.preventDefault(),$n(u,xp(o.value,l.value)).then(p=>{location.hash=et("rig",{name:p.path})},p=>c.replaceChildren(vt(p)))}),i.replaceChildren(h("h1",{},e),h("p",{class:"muted"},t),j1(n,r),n.length?h("div",{class:"table",tabindex:"0",role:"region","aria-label":F("files")},h("table",{},h("thead",{},h("tr",{},...[F("file"),F("what it is"),F("size"),F("written (UTC)"),F("to do")].map(f=>h("th",{scope:"col"},f)))),h("tbody",{},...a))):h("p",{class:"empty"},F("No rigs, roads or records lie here yet. Start from a rig that comes with jounce, or put your files into the folder.")),h("h2",{},F("Start from an example")),d,c,...r.length?[h("h2",{},F("Runs that were kept")),J1(r)]:[])}function j1(i,e){let t=a=>i.filter(o=>o.kind===a),[n]=t("rig"),s=t("record").find(a=>!e.some(({path:o})=>o===a.path)),r=[];return n?(e.length||r.push(h("li",{},h("a",{href:et("trial",{rig:n.path})},F("Drive # over an obstacle",n.path)),F(", and keep the run."))),e.length===1&&r.push(h("li",{},h("a",{href:et("trial",{rig:n.path})},F("Change # and keep another run",n.path)),F(", to compare the two."))),s&&!t("campaign").length&&r.push(h("li",{},h("a",{href:et("trial",{rig:n.path,record:s.path})},F("Look at # beside a run",s.path)),".")),t("sweep").length||r.push(h("li",{},h("a",{href:et("studies")},F("Vary its numbers in a study")),"."))):r.push(h("li",{},F("Start from a shipped rig, below."))),r.length?h("section",{class:"next","aria-label":F("What to do next")},h("h2",{},F("What to do next")),h("ul",{},...r)):h("section",{hidden:!0})}function J1(i){let e=i.map((a,o)=>h("input",{type:"checkbox","aria-label":F("compare #",a.path),checked:o<2})),t=h("div",{}),n=h("button",{type:"button"},F("Compare those that are chosen")),s=a=>h("code",{title:a},a.slice(0,8));n.addEventListener("click",()=>{let a=i.filter((o,l)=>e[l].checked).map(o=>o.path).slice(0,6);if(!a.length){t.replaceChildren(h("p",{class:"muted"},F("Choose one or more of them.")));return}yo("/api/compare",{paths:a}).then(o=>{let l=zn.of(o);t.replaceChildren(new vs(l.content.viewers[0],l).element,h("div",{class:"ways"},...Ff(l.content)))},o=>t.replaceChildren(vt(o)))});let r=({trial:a})=>`${F(String(a.road.kind??"").replace("-"," "))} ${Object.entries(a.road).filter(([o])=>!["kind","start"].includes(o)).map(([,o])=>o).join(" × ")}, ${a.speed}`;return h("section",{},h("div",{class:"table",tabindex:"0",role:"region","aria-label":F("Runs that were kept")},h("table",{},h("thead",{},h("tr",{},...["",F("run"),F("rig"),F("changes"),F("trial"),F("inputs"),F("seed"),F("version"),F("kept (UTC)")].map(a=>h("th",{scope:"col"},a||h("span",{class:"hidden"},F("compare")))))),h("tbody",{},...i.map((a,o)=>h("tr",{},h("td",{},e[o]),h("th",{scope:"row"},h("a",{href:et("record",{path:a.path})},a.path.replace(/^runs\//,""))),h("td",{},a.rig),h("td",{},Object.entries(a.changes).map(([l,c])=>`${l} = ${typeof c=="number"?xe(c,5):c}`).join(", ")||"–"),h("td",{},r(a)),h("td",{},s(a.rig_digest)," ",s(a.trial_digest)),h("td",{},a.seed===null?"–":String(a.seed)),h("td",{},a.version),h("td",{},pv(a.when))))))),h("p",{class:"bar"},n),t)}var mv={label:"Records",show:eT},Q1=3;async function eT(i,e){let t=e.get("path");if(!t){await xr(i,"record",F("Records"),"path",!1,["record"]);return}let n=performance.now(),s=await en(`/api/record?${ii({path:t})}`),r=new Set(s.channels.slice(0,Q1).map(m=>m.name)),a=new Vs,o=[];yr({times:o});let l=h("p",{class:"state",role:"status"}),c=!1,u=[s.first,s.last],d=new eo(m=>d.mark(m),m=>{c||(u=m,f())}),f=()=>a.ask(async()=>{if(!r.size||!i.isConnected)return;let m=performance.now(),[v,x]=u,S=x-v;try{let y=zn.of(await yo("/api/record",{path:t,channels:[...r],low:Math.max(s.first,v-S),high:Math.min(s.last,x+S),columns:Math.max(600,3*Math.round(d.element.clientWidth))})),T=y.content.viewers[0].scenes[0];c=!0,d.show({x:y.get(T.x),xLabel:`${F("time")} [${s.unit}]`,spans:[],window:null,whole:[s.first,s.last],panes:T.panes.map(M=>({title:M.name,unit:M.unit,lines:M.curves.map(b=>({label:"",role:b.role,y:y.get(b.y),step:0,shown:!0}))}))},u),c=!1,o.push(performance.now()-m),l.textContent="",l.classList.remove("problem")}catch(y){c=!1,l.textContent=y instanceof Error?y.message:String(y),l.classList.add("problem")}}),p=h("div",{class:"group",role:"group","aria-label":F("channels")},...s.channels.map(({name:m,unit:v})=>pi(m,r.has(m),x=>{x?r.add(m):r.delete(m),f()},v))),g=h("div",{class:"group"},...[["+",F("zoom in"),()=>d.zoomBy(.5)],["−",F("zoom out"),()=>d.zoomBy(2)],["‹",F("to the left"),()=>d.pan(-.5)],["›",F("to the right"),()=>d.pan(.5)],[F("All"),F("everything"),()=>d.reset()]].map(([m,v,x])=>h("button",{type:"button",title:v,"aria-label":v,click:x},m))),_=h("div",{class:"player",tabindex:"0",role:"region","aria-label":F("curves")},h("div",{class:"bar"},p,h("span",{class:"grow"}),g),h("div",{class:"plots-only"},d.element));_.addEventListener("keydown",m=>{if(m.ctrlKey||m.altKey||m.metaKey)return;let x={ArrowLeft:()=>d.pan(-.2),ArrowRight:()=>d.pan(.2),"+":()=>d.zoomBy(.5),"-":()=>d.zoomBy(2),0:()=>d.reset()}[m.key];x&&(m.preventDefault(),x())}),jn(()=>d.repaint()),i.replaceChildren(h("h1",{},t),h("p",{class:"muted"},`${F("# samples",String(s.count))}, ${s.even?`${F("every")} ${fi(String(Number(s.step.toPrecision(6))))} ${s.unit}`:F("not evenly spaced")}, ${fi(String(Number(s.first.toPrecision(9))))} – ${fi(String(Number(s.last.toPrecision(9))))} ${s.unit}; ${F("units as they are in the file")}`),h("p",{class:"bar"},h("a",{href:et("trial",{record:t})},F("Beside a run"))),...(s.left_out??[]).map(m=>h("p",{class:"problem"},`${F("not shown")}: ${mi(m)}`)),s.channels.length?_:h("p",{class:"empty"},F("There is nothing in it but time.")),l,h("p",{class:"muted"},F("Drag to zoom, Shift + wheel or ← → pans, Ctrl + wheel zooms, double click for everything."))),await f(),o.unshift(performance.now()-n)}var gv={label:"Ride and control",show:sT},tT=[["comfort","body, weighted r.m.s. (Wk)","m/s²",1],["body_acceleration","body r.m.s.","m/s²",1],["travel","strut travel r.m.s., worst corner","mm",1e3],["travel_range","strut travel, whole range, worst corner","mm",1e3],["load_coefficient","dynamic wheel load coefficient, worst corner","%",100],["lift_off","time lifted off, worst corner","%",100]],nT={m:["mm",1e3],"m/s^2":["m/s²",1],"N/m":["N/mm",.001],"N*s/m":["N·s/m",1],1:["–",1],"kg*m^2":["kg·m²",1]},iT=i=>{try{return JSON.parse(i??"{}")??{}}catch{return{}}},au=(i,e="")=>h("select",{},...i.map(t=>h("option",t===e?{value:t,selected:!0}:{value:t},t)));async function sT(i,e){let t=e.get("job");if(t){await oT(i,t);return}let[{entries:n},s,r]=await Promise.all([Ln(),en("/api/choices"),Ri()]),a=[...n.filter(y=>Ui.includes(y.kind)).map(y=>y.path),...r.map(y=>y.name)],o=[..."ABCDEFGH".split("").map(y=>`iso:${y}`),...s.roads,...n.filter(y=>y.kind==="road").map(y=>y.path)],l=au(a,e.get("vehicle")??"audi-a6-quarter-car"),c=au(o,e.get("road")??"iso:C"),u=iT(e.get("set")),d=(y,T="")=>h("input",{type:"text",value:y,placeholder:T,spellcheck:"false"}),f=d(e.get("speed")??"20 m/s"),p=d(e.get("duration")??"20 s"),g=h("input",{type:"number",min:"0",value:"0"}),_=h("fieldset",{class:"free"},h("legend",{},"Controllers"),...s.controls.map(y=>h("label",{},h("input",y==="passive"||y==="skyhook"?{type:"checkbox",value:y,checked:!0}:{type:"checkbox",value:y}),` ${y}`))),m=h("div",{"aria-live":"polite"}),v=h("button",{type:"submit",class:"main"},"Drive"),x=h("form",{});x.addEventListener("submit",y=>{y.preventDefault();let T=[..._.querySelectorAll("input:checked")].map(M=>M.value);$n(v,mr({kind:"compare",vehicle:l.value,road:c.value,speed:f.value,duration:p.value,seed:Number(g.value),control:T.length?T:["passive"],changes:u})).then(M=>{location.hash=et("ride",{job:M.id})},M=>m.replaceChildren(vt(M)))});let S=Object.entries(u);x.append(h("div",{class:"form"},me("Vehicle or rig",l),me("Road",c),me("Speed",f),me("Duration",p),me("Seed",g)),...S.length?[h("p",{class:"muted"},`changed (SI): ${S.map(([y,T])=>`${y} = ${xe(Number(T),5)}`).join(", ")} `,h("a",{href:et("ride",{vehicle:l.value})},"as it is"))]:[],_,h("div",{class:"bar"},v),m),i.replaceChildren(h("h1",{},"Ride and control"),h("p",{class:"muted"},"A vehicle over a rough road, passive and with controllers: comfort beside travel and road holding, in numbers, over time and as spectra."),x,h("h2",{},"Best designs"),aT(a,o),h("h2",{},"Rides and fronts"),_r(["compare","pareto"],y=>{location.hash=et("ride",{job:y.id})},"Nothing was driven here yet."),h("h2",{},"Rides over each other"),rT())}function rT(){let i=h("fieldset",{class:"free"},h("legend",{},"Rides that are done")),e=new Map,t=new Set,n=h("p",{class:"empty"},"Drive first: every ride that is done can be chosen here."),s=h("select",{},h("option",{value:"0"},F("time")),h("option",{value:"1"},"frequency (spectra)")),r=()=>{};s.addEventListener("change",()=>r());let a=new Ti("Draw them",()=>({kind:"overlay",rides:[...e.values()]}),({result:c,...u})=>{let d=h("div",{});return zn.open(JSON.stringify(c.content)).then(f=>{r=()=>{let p=f.content.viewers[Number(s.value)];p&&d.replaceChildren(new vs(p,f).element)},r()}),[...Object.entries(c.failed).map(([f,p])=>h("p",{class:"problem"},`not run: ${f}: ${p}`)),...c.notes.map(f=>h("p",{class:"muted"},f)),d,Un(u)]}),o=h("div",{class:"form"},me("Curves over",s),a.button),l=h("section",{},n,i,o,a.place);return i.hidden=o.hidden=!0,vr(l,c=>{for(let u of c.filter(d=>d.kind==="compare"&&d.state==="done").reverse()){let{control:d,...f}=u.asked;for(let p of d){let g={...f,control:p},_=JSON.stringify(g);if(delete g.kind,t.has(_))continue;t.add(_);let m=h("input",{type:"checkbox"});m.addEventListener("change",()=>{m.checked?e.set(_,g):e.delete(_),a.button.disabled=!e.size});let v=Object.entries(g.changes).map(([x,S])=>`, ${x} = ${typeof S=="number"?xe(S,4):String(S)}`).join("");i.append(h("label",{},m,` ${u.title}${g.seed?`, ${g.seed}`:""}, ${p}${v}`))}}n.hidden=t.size>0,i.hidden=o.hidden=!t.size,a.button.disabled=!e.size}),l}function aT(i,e){let t=(m,v="")=>h("input",{type:"text",value:m,placeholder:v,spellcheck:"false"}),n=au(i,"audi-a6-quarter-car"),s=au(e.filter(m=>m.startsWith("iso:")),"iso:C"),r=t("20 m/s"),a=h("input",{type:"number",min:"2",max:"200",value:"12"}),o=h("div",{}),l=h("datalist",{id:"paths-that-are-free"}),c=h("div",{"aria-live":"polite"}),u=t("","20 mm"),d=[],f=(m="")=>{let v=d.find(T=>T.path===m),x=v?`${Number((.3*v.value*v.factor).toPrecision(3))}..${Number((3*v.value*v.factor).toPrecision(3))} ${v.unit}`:"",S=h("input",{type:"text",value:m,list:"paths-that-are-free","aria-label":"number that is free",size:"30"}),y=h("input",{type:"text",value:x,placeholder:"low..high unit, or ±30 %","aria-label":"its bounds"});o.append(h("div",{class:"bar pair"},S,y))},p=async()=>{try{d=(await ls(n.value)).numbers,l.replaceChildren(...d.map(m=>h("option",{value:m.path}))),o.replaceChildren(),f(d.find(m=>/damper\.coefficient$/.test(m.path))?.path??d[0]?.path),c.replaceChildren()}catch(m){c.replaceChildren(vt(m))}};n.addEventListener("change",()=>{p()});let g=h("button",{type:"button"},"Another number"),_=h("button",{type:"button",class:"main"},"Search");return g.addEventListener("click",()=>f()),_.addEventListener("click",()=>{let m=Object.fromEntries([...o.children].map(v=>[...v.querySelectorAll("input")].map(x=>x.value.trim())).filter(([v])=>v));$n(_,mr({kind:"pareto",vehicle:n.value,road:s.value,speed:r.value,free:m,points:Number(a.value),limit:u.value?{"strut.deflection":u.value}:{}})).then(v=>{location.hash=et("ride",{job:v.id})},v=>c.replaceChildren(vt(v)))}),p(),h("section",{},h("p",{class:"muted"},"From the most comfortable design to the one that holds the road best; each of them opens as a ride."),h("div",{class:"form"},me("Vehicle or rig",n),me("Road",s),me("Speed",r),me("Designs",a),me("Most travel r.m.s., if any",u)),o,l,h("div",{class:"bar"},g,_),c)}async function oT(i,e){let t=await gr(e),n=h("div",{}),s=new Gs(t),r=!1;i.replaceChildren(h("h1",{},t.title),h("p",{},h("a",{href:et("ride")},"All rides")),s.element,n);let a=async o=>{if(s.show(o),o.state!=="done"||r)return;r=!0;let l=await gr(e);l.result&&n.replaceChildren(..."runs"in l.result?lT(l.result):cT(l.result,l.asked),...iv("runs"in l.result?l.result:null),Un(l),...l.has_page?[_s(`/api/jobs/${e}/report`,"runs"in l.result?"Over time, as spectra, and every metric":"Report")]:[])};await a(t),vr(i,o=>{let l=o.find(c=>c.id===e);l&&a(l)})}function lT(i){let e=tT.filter(([s])=>i.runs.some(r=>Number.isFinite(r.merits[s]))),t=Object.fromEntries(e.map(([s])=>[s,Math.min(...i.runs.map(r=>r.merits[s]??1/0))])),n=i.runs.find(s=>s.control==="passive");return[h("div",{class:"table",tabindex:"0",role:"region","aria-label":"controllers"},h("table",{},h("caption",{},"Smaller is better; in brackets the change from the passive rig"),h("thead",{},h("tr",{},h("th",{scope:"col"},"controller"),...e.map(([,s,r])=>h("th",{scope:"col",class:"right"},`${F(s)} [${r}]`)),h("th",{scope:"col"},"comfort"))),h("tbody",{},...i.runs.map(s=>h("tr",{},h("th",{scope:"row"},s.control),...e.map(([r,,,a])=>{let o=s.merits[r],l=n?.merits[r],c=o!==void 0&&l&&s!==n?` (${o>=l?"+":""}${xe(100*(o/l-1),2)} %)`:"";return h("td",{class:"right"},o!==void 0&&o===t[r]&&i.runs.length>1&&o>0?h("span",{class:"mark good"},xe(o*a)):xe(o===void 0?null:o*a),c)}),h("td",{},Object.values(s.comfort).map(r=>F(r)).join("; "))))))),...Object.entries(i.failed).map(([s,r])=>h("p",{class:"problem"},`not run: ${s}: ${r}`)),...[...new Set(i.runs.flatMap(s=>s.findings.map(r=>`${r.severity}: ${r.place}: ${r.message}`)))].map(s=>h("p",{class:"muted"},s))]}function cT(i,e){let t=[...i.comfort.map((y,T)=>({name:`design ${T+1}`,comfort:y,holding:i.holding[T],travel:i.travel[T],values:Object.fromEntries(Object.entries(i.numbers).map(([M,b])=>[M,b[T]])),on:!0})),...i.marks.map(y=>({...y,name:`${y.name} (${y.kind})`,on:!1}))],n=y=>nT[y]??[y,1],s=y=>et("ride",{vehicle:String(e.vehicle),road:String(e.road),speed:String(e.speed),set:JSON.stringify(y.values)}),r=y=>{let T=Math.min(...y),M=Math.max(...y),b=.06*(M-T||1);return[T-b,M+b]},[a,o]=r(t.map(y=>y.comfort)),[l,c]=r(t.map(y=>y.holding)),[u,d,f,p]=[560,340,66,40],g=(y,T,M="")=>{let b=document.createElementNS("http://www.w3.org/2000/svg",y);for(let[A,O]of Object.entries(T))b.setAttribute(A,String(O));return b.textContent=M,b},_=y=>f+(u-f-12)*(y-a)/(o-a),m=y=>d-p-(d-p-10)*(y-l)/(c-l),v=g("svg",{viewBox:`0 0 ${u} ${d}`,class:"xy",role:"group","aria-label":"Pareto front"});v.append(g("path",{class:"axis",d:`M${f} 6V${d-p}H${u-8}`}));for(let y of[a,o])v.append(g("text",{x:_(y),y:d-p+16,"text-anchor":y===a?"start":"end"},xe(y*n(i.units.comfort)[1],3)));for(let y of[l,c])v.append(g("text",{x:f-5,y:m(y)+(y===l?0:10),"text-anchor":"end"},xe(y*n(i.units.holding)[1],3)));v.append(g("text",{x:(f+u)/2,y:d-8,"text-anchor":"middle"},`${i.metrics.comfort} [${n(i.units.comfort)[0]}]`),g("text",{x:13,y:d/2,transform:`rotate(-90 13 ${d/2})`,"text-anchor":"middle"},`${i.metrics.holding} [${n(i.units.holding)[0]}]`)),v.append(g("path",{class:"search",d:t.filter(y=>y.on).sort((y,T)=>y.comfort-T.comfort).map((y,T)=>`${T?"L":"M"}${_(y.comfort).toFixed(1)} ${m(y.holding).toFixed(1)}`).join("")}));for(let y of t){let T=g("a",{href:s(y),"aria-label":`drive ${y.name}`});T.append(g("title",{},`${y.name}: drive it`),y.on?g("circle",{cx:_(y.comfort),cy:m(y.holding),r:6,class:"on"}):g("rect",{x:_(y.comfort)-5,y:m(y.holding)-5,width:10,height:10,class:"off"})),v.append(T)}let x=h("figure",{}),S=Object.keys(i.numbers);return x.append(v,h("figcaption",{class:"muted"},`${i.driven}; round: the front, square: the rig as it is and single best dampers. Each opens as a ride.`)),[...i.converged?[]:[h("p",{class:"mark fair"},"Not every design is surely the best of its kind.")],x,h("div",{class:"table",tabindex:"0",role:"region","aria-label":"designs"},h("table",{},h("thead",{},h("tr",{},h("th",{scope:"col"},"design"),...["comfort","holding","travel"].map(y=>h("th",{scope:"col",class:"right"},`${i.metrics[y]} [${n(i.units[y])[0]}]`)),...S.map(y=>h("th",{scope:"col",class:"right"},`${y} [${n(i.number_units[y])[0]}]`)),h("th",{scope:"col"},""))),h("tbody",{},...t.map(y=>h("tr",{},h("th",{scope:"row"},y.name),...["comfort","holding","travel"].map(T=>h("td",{class:"right"},xe(y[T]*n(i.units[T])[1]))),...S.map(T=>h("td",{class:"right"},xe(y.values[T]===void 0?null:y.values[T]*n(i.number_units[T])[1]))),h("td",{},h("a",{href:s(y),"aria-label":`drive ${y.name}, as a ride`},"drive it"))))))),...i.findings.map(y=>h("p",{class:"muted"},`${y.severity}: ${y.message}`))]}var vv=["schema","model"],Gf=i=>typeof i=="object"&&i!==null&&!Array.isArray(i),Hf=i=>i.map((e,t)=>typeof e=="number"?`[${e}]`:t?`.${e}`:e).join(""),ou=class{constructor(e){this.changed=e}changed;element=h("div",{class:"described"});open=new Set(["hardpoints","strut","sprung","unsprung","tyre"]);definitions={};problems=[];show(e,t,n){let s=document.activeElement?.closest("[data-path]")?.dataset.path,r=this.element.contains(document.activeElement);this.definitions=e.$defs??{},this.problems=n,this.element.replaceChildren(...this.rows(e,t,[]));let a=new Set([...this.element.querySelectorAll("[data-path]")].map(l=>l.dataset.path)),o=n.filter(l=>!a.has(l.path));o.length&&this.element.prepend(...o.map(l=>h("p",{class:"problem",role:"alert"},`${l.line?`${F("line #",String(l.line))}: `:""}${l.path?`${l.path}: `:""}${l.text}`))),r&&s&&this.element.querySelector(`[data-path="${CSS.escape(s)}"]`)?.querySelector("input, select")?.focus()}resolved(e){return e.$ref?this.definitions[e.$ref.split("/").pop()]:e}choices(e){let t=this.resolved(e),n=t.anyOf??t.oneOf;return n?n.flatMap(s=>this.choices(s)).filter(s=>s.type!=="null"):[t]}rows(e,t,n){let s=this.resolved(e),r=s.properties??{},a=[...Object.keys(t),...(s.required??[]).filter(u=>!(u in t))].filter(u=>n.length||!vv.includes(u)),o=[],l=[];for(let u of a){let d=this.field(u,r[u]??{},t[u],[...n,u],(s.required??[]).includes(u)||!r[u]?.$ref&&r[u]?.default===void 0);(d.tagName==="DETAILS"?l:o).push(d)}let c=Object.keys(r).filter(u=>!(u in t)&&!a.includes(u)&&!(vv.includes(u)&&!n.length));return[...o,...l,...c.length?[this.more(c,r,n)]:[]]}more(e,t,n){let s=h("select",{"aria-label":F("Add to #",Hf(n)||F("the rig"))},h("option",{value:""},F("add …")),...e.map(r=>h("option",{value:r},r.replaceAll("_"," "))));return s.addEventListener("change",()=>{s.value&&(this.open.add(Hf([...n,s.value])),this.changed([...n,s.value],this.first(t[s.value])))}),h("p",{class:"add"},s)}first(e){if(e.default!==void 0&&e.default!==null&&!Gf(e.default))return e.default;let t=this.choices(e)[0];return t.const!==void 0?t.const:t.enum?t.enum[0]:t.properties?Object.fromEntries(Object.entries(t.properties).filter(([n,s])=>t.required?.includes(n)||s.const!==void 0).map(([n,s])=>[n,this.first(s)])):t.prefixItems?t.prefixItems.map(n=>this.first(n)):t.type==="array"?[]:t.type==="boolean"?!1:"?"}field(e,t,n,s,r){let a=Hf(s),o=this.problems.filter(v=>v.path===a),l=`f-${a}`,c=typeof s[s.length-1]=="number"?String(s[s.length-1]):e.replaceAll("_"," "),u=o.length?[h("span",{class:"wrong",role:"alert",id:`${l}-wrong`},o.map(v=>v.text).join(" "))]:[],d=r?[]:[h("button",{type:"button",class:"away",title:F("Take # away",a),"aria-label":F("Take # away",a),click:()=>this.changed(s,null)},"×")],f=this.choices(t);if(Gf(n)||n===void 0&&f.some(v=>v.properties)){let v=h("details",{"data-path":a,open:this.open.has(a)||this.problems.some(M=>M.path.startsWith(a))});v.addEventListener("toggle",()=>{v.open?this.open.add(a):this.open.delete(a)});let x=Gf(n)?n:{},S=f.filter(M=>M.properties),y=this.kindOf(S,x),T=h("select",{"aria-label":F("kind of #",a)},...S.map((M,b)=>h("option",{value:String(b),...M===y?{selected:!0}:{}},hT(M.title??""))));return T.addEventListener("change",()=>this.changed(s,this.become(S[Number(T.value)],x))),v.append(h("summary",{},c),...S.length>1?[h("p",{class:"kind"},T)]:[],...u,...this.rows(y??{},x,s),...d),v}let p={id:l,...o.length?{"aria-invalid":"true","aria-describedby":`${l}-wrong`}:{}};if(Array.isArray(n)&&n.every(v=>typeof v!="object")){let v=f.find(x=>x.prefixItems)?.prefixItems;if(v&&v.length===n.length){let x=this.problems.filter(y=>y.path.startsWith(`${a}[`)),S=n.map((y,T)=>this.typed(String(y),v[T],[...s,T],{"aria-label":`${a}[${T}]`,...x.some(M=>M.path===`${a}[${T}]`)?{"aria-invalid":"true"}:{}}));return h("div",{class:"row","data-path":a},h("span",{class:"name"},c),h("span",{class:"three"},...S.map((y,T)=>h("span",{"data-path":`${a}[${T}]`},y))),...d,...u,...x.map(y=>h("span",{class:"wrong",role:"alert"},`${y.path}: ${y.text}`)))}}let g,_=f.find(v=>v.enum);if(_?.enum&&typeof n=="string"){let v=h("select",p,...[...new Set([n,..._.enum])].map(x=>h("option",{value:x,...x===n?{selected:!0}:{}},x)));v.addEventListener("change",()=>this.changed(s,v.value)),g=v}else if(typeof n=="boolean"){let v=h("input",{type:"checkbox",...p,checked:n});v.addEventListener("change",()=>this.changed(s,v.checked)),g=v}else f.length===1&&f[0].const!==void 0?g=h("output",p,String(n)):g=this.typed(n===void 0?"":typeof n=="object"?JSON.stringify(n):String(n),t,s,p,typeof n=="object");let m=t.description??f.find(v=>v.description)?.description??"";return h("div",{class:"row","data-path":a},h("label",{class:"name",for:l,title:m},c),g,...d,...u)}typed(e,t,n,s,r=!1){let a=h("input",{type:"text",spellcheck:"false",value:e,...s}),o=this.choices(t).map(l=>l.type);return a.addEventListener("change",()=>{let l=a.value.trim();if(r)try{this.changed(n,JSON.parse(l))}catch{this.changed(n,l)}else this.changed(n,l!==""&&!Number.isNaN(Number(l))&&o.some(c=>c==="number"||c==="integer")?Number(l):l)}),a}kindOf(e,t){let n=e.find(r=>r.properties?.kind?.const!==void 0&&r.properties.kind.const===t.kind),s=r=>Object.keys(t).filter(a=>a in r.properties).length-Object.keys(t).filter(a=>!(a in r.properties)).length-(r.required??[]).filter(a=>!(a in t)).length;return n??[...e].sort((r,a)=>s(a)-s(r))[0]}become(e,t){let n=this.first(e);for(let[s,r]of Object.entries(t))s!=="kind"&&s in e.properties&&(n[s]=r);return n}};function hT(i){return i.replace(/([a-z])([A-Z])/g,"$1 $2").toLowerCase()}var _v={label:"Rig",show:uT};async function uT(i,e){let t=e.get("name");if(!t){await xr(i,"rig",F("Rig"),"name");return}let n=await Er(t),s=null,r=[],a=[],o=h("textarea",{spellcheck:"false","aria-label":F("text of #",t),rows:"28"});o.value=n.text;let l=n.text,c=h("div",{class:"told","aria-live":"polite"}),u=h("div",{}),d=h("button",{type:"button",class:"main",disabled:!0},F("Save")),f=h("button",{type:"button",disabled:!0},F("Undo")),p=h("button",{type:"button",disabled:!0},F("Redo")),g=new Vs,_=new Vs,m=new ou((P,k)=>{A({sets:[[P,k]]})}),v=new dr(!0),x=h("div",{class:"player bare",hidden:!0},v.element),S=new ro(v,(P,k)=>{k?A({changes:P}):M(P)}),y=h("section",{hidden:!0,"aria-label":F("The mechanism")},h("h2",{},F("The mechanism")),h("p",{class:"muted"},F("Drag a hardpoint, or choose it and type its place; drag beside them to turn the picture.")),S.element,x),T=()=>{d.disabled=o.value===n.text,f.disabled=!r.length,p.disabled=!a.length},M=(P={})=>_.ask(async()=>{if(s?.rig?.spatial)try{let k=zn.of(await da("kinematics",{rig:t,text:o.value,changes:P,travel:"-20 mm:20 mm:10 mm",channels:["camber"]})),B=k.content.viewers[0].scenes[0].motion;if(!B)return;y.hidden=x.hidden=!1,v.show(k.content.mechanisms[B.mechanism],B),v.set({body:0,travel:0,ground:k.content.mechanisms[B.mechanism].contact[2][2],load:1,time:0})}catch(k){c.replaceChildren(vt(k))}}),b=async(P,k)=>{if(k&&P.text!==l&&(r.push(l),a.length=0),l=P.text,o.value!==P.text&&(o.value=P.text),s=P,T(),P.model)try{m.show(await bp(P.model),P.values,P.problems)}catch{m.element.replaceChildren()}let B=P.problems.map(L=>vt(new Error(`${L.line?`${F("line #",String(L.line))}: `:""}${L.path?`${L.path}: `:""}${L.text}`)));c.replaceChildren(...B.length?B:[h("p",{class:"good"},F("#: nothing is wrong with it.",`${P.model}, ${F("# numbers",String(P.rig?.numbers.length??0))}`))],...(P.rig?.findings??[]).map(L=>h("p",{},L))),u.replaceChildren(),P.rig&&(S.set(P.rig.numbers),await M()),P.rig&&!P.rig.spatial&&(y.hidden=!0)},A=P=>g.ask(async()=>{try{await b(await Gi(t,o.value,P.sets??[],P.changes??{}),!0)}catch(k){c.replaceChildren(vt(k))}}),O=0;o.addEventListener("input",()=>{d.disabled=o.value===n.text,clearTimeout(O),O=setTimeout(()=>{A({})},400)});let N=(P,k)=>{let B=P.pop();B!==void 0&&(k.push(l),l=B,o.value=B,g.ask(async()=>{await b(await Gi(t,B,[],{}),!1)}))};f.addEventListener("click",()=>N(r,a)),p.addEventListener("click",()=>N(a,r)),i.addEventListener("keydown",P=>{!(P.ctrlKey||P.metaKey)||P.target===o||(P.key==="z"&&!P.shiftKey&&(P.preventDefault(),N(r,a)),(P.key==="y"||P.key==="Z"&&P.shiftKey)&&(P.preventDefault(),N(a,r)))}),d.addEventListener("click",()=>{let P=h("button",{type:"button",class:"main"},F("Write it")),k=h("button",{type:"button"},F("Back"));k.addEventListener("click",()=>u.replaceChildren()),P.addEventListener("click",()=>{$n(P,Tr(t,o.value,n.digest)).then(async L=>{n=L,T(),await b(await Gi(t,L.text,[],{}),!1),c.prepend(h("p",{class:"good"},F("Saved.")))},L=>u.replaceChildren(vt(L),h("div",{class:"bar"},B)))});let B=h("button",{type:"button"},F("Load it again"));B.addEventListener("click",()=>{g.ask(async()=>{try{n=await Er(t),await b(await Gi(t,n.text,[],{}),!0)}catch(L){u.prepend(vt(L))}})}),g.ask(async()=>{let L=await Gi(t,o.value,[],{});u.replaceChildren(h("section",{class:"difference","aria-label":F("What is changed")},h("h2",{},F("What is changed")),...L.problems.length?[h("p",{class:"problem"},F("Something is still wrong with it; it can be saved all the same."))]:[],h("pre",{tabindex:"0","aria-label":F("What is changed")},...L.changed.map(H=>h("span",{class:H.startsWith("+")?"added":H.startsWith("-")?"removed":H.startsWith("@@")?"muted":""},`${H}
`))),h("div",{class:"bar"},P,k))),P.focus()})}),jn(()=>{v.repaint()}),i.replaceChildren(h("h1",{},t),h("p",{class:"bar"},h("a",{href:et("trial",{rig:t})},F("Drive it over an obstacle")),h("a",{href:et("kinematics",{rig:t})},F("Look at its kinematics"))),c,h("div",{class:"bar"},d,f,p),u,y,h("div",{class:"two"},h("section",{"aria-label":F("Form")},h("h2",{},F("Form")),m.element),h("section",{"aria-label":F("File")},h("h2",{},F("File")),o))),await b(await Gi(t,n.text,[],{}),!1)}var Kr={"half-sine":["height","length"],versine:["height","length"],rectangle:["height","length"],triangle:["height","length"],step:["height"],pothole:["depth","length"]},lu={height:"10 mm",depth:"10 mm",length:"60 mm"};var ao=i=>`${i.name} [${i.unit||"–"}]`,du=i=>{let e=1/0,t=-1/0;for(let n of i)n!==null&&(n<e&&(e=n),n>t&&(t=n));return e<t?[e,t]:e===t?[e-(Math.abs(e)||1)*.5,e+(Math.abs(e)||1)*.5]:[0,1]},fu=class{constructor(e){this.columns=e;this.count()}columns;ranges=new Map;chosen=[];picked=-1;listeners=[];listen(e){this.listeners.push(e)}set(e,t){t?this.ranges.set(e,t):this.ranges.delete(e),this.count()}clear(){this.ranges.clear(),this.count()}pick(e){this.picked=e;for(let t of this.listeners)t()}count(){let e=this.columns[0]?.values.length??0;this.chosen=Array.from({length:e},(t,n)=>[...this.ranges].every(([s,[r,a]])=>{let o=this.columns[s].values[n];return o!=null&&o>=r&&o<=a}));for(let t of this.listeners)t()}};function yv(i,e){let t=Math.min(window.devicePixelRatio||1,2),n=h("canvas",{width:String(Math.round(i*t)),height:String(Math.round(e*t))}),s=n.getContext("2d");return s.scale(t,t),n.style.width=`${i}px`,n.style.height=`${e}px`,[n,s]}var cu=130,jr=26,Tl=250,dT=22;function xv(i){let{columns:e}=i,t=e.map(p=>du(p.values)),n=cu*e.length,s=jr+Tl+dT,[r,a]=yv(n,s);r.setAttribute("role","img"),r.setAttribute("aria-label",`every variant as a line through ${e.map(ao).join(", ")}`);let o=p=>cu*(p+.5),l=(p,g)=>{let[_,m]=t[p];return jr+Tl*(1-(g-_)/(m-_))},c=()=>{a.clearRect(0,0,n,s);let p=_=>{a.beginPath();let m=!1;e.forEach((v,x)=>{let S=v.values[_];if(S==null){m=!1;return}m?a.lineTo(o(x),l(x,S)):a.moveTo(o(x),l(x,S)),m=!0}),a.stroke()},g=i.chosen.length;if(a.lineWidth=1,a.strokeStyle=xt("line"),i.ranges.size)for(let _=0;_<g;_++)i.chosen[_]||p(_);a.strokeStyle=xt("accent"),a.globalAlpha=Math.max(.08,Math.min(.7,60/Math.max(g,1)));for(let _=0;_<g;_++)i.chosen[_]&&p(_);a.globalAlpha=1,i.picked>=0&&(a.strokeStyle=xt("other-5"),a.lineWidth=2.5,p(i.picked)),a.font="12px system-ui, sans-serif",a.textAlign="center",e.forEach((_,m)=>{let[v,x]=t[m];a.strokeStyle=xt("edge"),a.lineWidth=1,a.beginPath(),a.moveTo(o(m),jr),a.lineTo(o(m),jr+Tl),a.stroke();let S=i.ranges.get(m);S&&(a.fillStyle=xt("other-5"),a.globalAlpha=.3,a.fillRect(o(m)-7,l(m,S[1]),14,Math.max(2,l(m,S[0])-l(m,S[1]))),a.globalAlpha=1),a.fillStyle=xt("ink"),a.fillText(xe(x,3),o(m),jr-8),a.fillText(xe(v,3),o(m),jr+Tl+15)})},u=null,d=p=>{let g=r.getBoundingClientRect(),_=Math.min(e.length-1,Math.max(0,Math.floor((p.clientX-g.left)/cu))),m=Math.min(1,Math.max(0,1-(p.clientY-g.top-jr)/Tl)),[v,x]=t[u?.k??_];return{k:_,value:v+m*(x-v)}};r.addEventListener("pointerdown",p=>{u=d(p),r.setPointerCapture(p.pointerId)}),r.addEventListener("pointermove",p=>{if(!u)return;let{value:g}=d(p),[_,m]=t[u.k];Math.abs(g-u.value)>.01*(m-_)&&i.set(u.k,[Math.min(g,u.value),Math.max(g,u.value)])}),r.addEventListener("pointerup",p=>{u&&Math.abs(d(p).value-u.value)<.01*(t[u.k][1]-t[u.k][0])&&i.set(u.k,null),u=null}),i.listen(c),jn(c),c();let f=h("div",{class:"axes"},...e.map(p=>h("span",{title:ao(p)},p.name,h("small",{},p.unit||"–"))));return f.style.width=`${n}px`,f.style.gridTemplateColumns=`repeat(${e.length}, ${cu}px)`,h("div",{class:"wide",tabindex:"0",role:"region","aria-label":"parallel coordinates"},f,r)}function bv(i){let e=i.columns.map((t,n)=>{let[s,r]=du(t.values),a=["from","to"].map(l=>h("input",{type:"number",step:"any","aria-label":`${t.name}, ${l} [${t.unit||"–"}]`,placeholder:xe(l==="from"?s:r,4)})),o=()=>{let[l,c]=a.map(u=>u.value);i.set(n,l||c?[l?Number(l):-1/0,c?Number(c):1/0]:null)};for(let l of a)l.addEventListener("change",o);return i.listen(()=>{let l=i.ranges.get(n);a.forEach((c,u)=>{document.activeElement!==c&&(c.value=l&&Number.isFinite(l[u])?String(Number(l[u].toPrecision(4))):"")})}),h("tr",{},h("th",{scope:"row"},t.name),h("td",{},a[0]),h("td",{},a[1]),h("td",{},t.unit||"–"))});return h("details",{},h("summary",{},"Ranges as numbers"),h("div",{class:"table",tabindex:"0",role:"region","aria-label":"ranges"},h("table",{},h("thead",{},h("tr",{},...["","from","to","unit"].map(t=>h("th",{scope:"col"},t)))),h("tbody",{},...e))))}var hu=170,Al=130,uu=8;function fT(i,e,t){let[n,s]=yv(hu,Al),[r,a]=du(e.values),[o,l]=du(t.values),c=f=>uu+(hu-2*uu)*(f-r)/(a-r),u=f=>Al-uu-(Al-2*uu)*(f-o)/(l-o);n.setAttribute("role","img"),n.setAttribute("aria-label",`${ao(t)} over ${ao(e)}: ${xe(o,3)} to ${xe(l,3)} over ${xe(r,3)} to ${xe(a,3)}`);let d=()=>{s.clearRect(0,0,hu,Al),s.strokeStyle=xt("edge"),s.strokeRect(.5,.5,hu-1,Al-1);let f=i.chosen.length,p=(g,_)=>{let m=e.values[g],v=t.values[g];m!=null&&v!==null&&v!==void 0&&s.fillRect(c(m)-_/2,u(v)-_/2,_,_)};s.fillStyle=xt("line");for(let g=0;g<f;g++)i.chosen[g]||p(g,2);s.fillStyle=xt("accent"),s.globalAlpha=f>400?.5:.9;for(let g=0;g<f;g++)i.chosen[g]&&p(g,2.5);s.globalAlpha=1,i.picked>=0&&(s.fillStyle=xt("other-5"),p(i.picked,7))};return n.addEventListener("click",f=>{let p=n.getBoundingClientRect(),g=[f.clientX-p.left,f.clientY-p.top],_=-1,m=15**2;e.values.forEach((v,x)=>{let S=t.values[x];if(v===null||S===null||S===void 0||!i.chosen[x])return;let y=(c(v)-g[0])**2+(u(S)-g[1])**2;y<m&&(m=y,_=x)}),_>=0&&i.pick(_)}),i.listen(d),jn(d),d(),n}function wv(i){let e=i.columns.filter(n=>n.is_number).slice(0,8),t=i.columns.filter(n=>!n.is_number).slice(0,6);return h("div",{class:"wide table",tabindex:"0",role:"region","aria-label":"matrix of dots"},h("table",{class:"matrix"},h("thead",{},h("tr",{},h("td",{}),...e.map(n=>h("th",{scope:"col"},ao(n))))),h("tbody",{},...t.map(n=>h("tr",{},h("th",{scope:"row"},ao(n)),...e.map(s=>h("td",{},fT(i,s,n))))))))}var pT=[["total","share of the variance, with others"],["mean_absolute_effect","mean size of effects"],["regression","regression coefficient"]];function Sv(i,e,t){let n=(d,f)=>{let p=d.measures[f];return typeof p=="number"?p:p?.value??NaN},s=i.filter(d=>d.metric===e.name),[r,a]=pT.find(([d])=>s.some(f=>Number.isFinite(n(f,d))))??["regression","regression coefficient"];s.sort((d,f)=>Math.abs(n(f,r))-Math.abs(n(d,r)));let o=s.map(d=>[n(d,"at_low"),n(d,"at_high")].map(f=>(f-t)*e.factor)),l=Math.max(1e-300,...o.flat().filter(Number.isFinite).map(Math.abs)),c=(d,f)=>{let p=document.createElementNS("http://www.w3.org/2000/svg",d);for(let[g,_]of Object.entries(f))p.setAttribute(g,String(_));return p},u=s.map((d,f)=>{let p=c("svg",{viewBox:"-100 0 200 16",class:"swing","aria-hidden":"true"});p.append(c("line",{x1:0,x2:0,y1:0,y2:16,class:"zero"})),o[f].forEach((_,m)=>{if(!Number.isFinite(_))return;let v=96*_/l;p.append(c("rect",{x:Math.min(0,v),width:Math.abs(v),y:m?8.5:1.5,height:6,class:m?"high":"low"}))});let g=o[f].map(_=>Number.isFinite(_)?`${_>0?"+":""}${xe(_,3)}`:"–");return h("tr",{},h("th",{scope:"row"},d.number),h("td",{class:"right"},g[0]),h("td",{},p),h("td",{class:"right"},g[1]),h("td",{class:"right"},xe(n(d,r),3)))});return h("div",{class:"table",tabindex:"0",role:"region","aria-label":`what ${e.name} depends on`},h("table",{},h("caption",{},`${e.name}: from its mean of ${xe(t*e.factor,4)} ${e.unit}, where a number is low and where it is high`),h("thead",{},h("tr",{},h("th",{scope:"col"},"number"),h("th",{scope:"col",class:"right"},h("span",{class:"key low"}),` ${F("low")} [${e.unit||"–"}]`),h("th",{scope:"col"},""),h("th",{scope:"col",class:"right"},h("span",{class:"key high"}),` ${F("high")} [${e.unit||"–"}]`),h("th",{scope:"col",class:"right"},a))),h("tbody",{},...u)))}var Ev={label:"Studies",show:mT};async function mT(i,e){let t=e.get("job"),n=e.get("folder");if(t||n){await Tv(i,t,n);return}let{entries:s}=await Ln(),r=[...s.filter(o=>Ui.includes(o.kind)).map(o=>o.path),...(await Ri()).map(o=>o.name)],a=s.filter(o=>o.kind==="sweep");i.replaceChildren(h("h1",{},"Studies"),h("p",{class:"muted"},"Numbers of a rig are spread over ranges or distributions; every variant is simulated, and what its metrics depend on is told."),h("h2",{},"Sweeps"),_r(["sweep"],o=>{location.hash=et("studies",{job:o.id})},"No sweep was begun here yet. Write a study below, or begin one that lies in the folder."),...a.length?[h("h2",{},"Studies that lie here"),h("ul",{},...a.map(o=>h("li",{},o.path," ",gT(o.path))))]:[],h("h2",{},"A new study"),await vT(r,e.get("rig")??""))}function gT(i){let e=i.replace(/\.toml$/,"-swept"),t=h("span",{}),n=h("button",{type:"button","aria-label":`Begin ${i}`},"Begin");return n.addEventListener("click",()=>{$n(n,mr({kind:"sweep",study:i,out:e,resume:!0})).then(()=>t.replaceChildren(),s=>t.replaceChildren(vt(s)))}),h("span",{},n," ",h("small",{class:"muted"},F("into #",e)),t)}var Wf={sobol:["Sobol: even over all numbers",!0],"latin-hypercube":["Latin hypercube",!0],"monte-carlo":["Monte Carlo: random",!0],grid:["Grid: every combination",!1],list:["List: one value of each a variant",!1],morris:["Morris: screening by trajectories",!0],saltelli:["Saltelli: indices of the variance",!0]},Mv={share:["± share",["20 %"]],range:["range",["from","to"]],normal:["normal",["mean","sd"]],triangular:["triangular",["low","mode","high"]],values:["values",["one, another, ..."]]};async function vT(i,e){if(!i.length)return h("p",{class:"empty"},"No rig lies here yet.");let t=h("select",{},...i.map(k=>h("option",k===e?{value:k,selected:!0}:{value:k},k))),n=h("tbody",{}),s=h("datalist",{id:"paths-of-the-rig"}),r=h("select",{},...Object.entries(Wf).map(([k,[B]])=>h("option",{value:k},B))),a=h("input",{type:"number",min:"1",value:"256"}),o=h("input",{type:"number",min:"0",value:"0"}),l=h("input",{type:"text",value:"rms sprung.az, max strut.deflection"}),c=h("select",{},...Object.keys(Kr).map(k=>h("option",{value:k},F(k.replace("-"," ")))),h("option",{value:"iso"},"random road (ISO 8608)")),u=h("span",{class:"sizes"}),d=h("input",{type:"text",value:"2 m/s"}),f=h("input",{type:"text",value:"1.5 s"}),p=h("input",{type:"text",value:"study.toml",spellcheck:"false"}),g=h("input",{type:"text",value:"swept",spellcheck:"false"}),_=h("div",{"aria-live":"polite"});p.addEventListener("change",()=>{g.value=`${p.value.replace(/\.toml$/,"")}-swept`});let m=[],v=(k="",B="share")=>{let L=h("input",{type:"text",value:k,list:"paths-of-the-rig","aria-label":"number that varies",size:"30",spellcheck:"false"}),H=h("select",{"aria-label":"how it is spread"},...Object.entries(Mv).map(([ne,[ue]])=>h("option",ne===B?{value:ne,selected:!0}:{value:ne},F(ue)))),Y=h("span",{class:"sizes"}),$=h("td",{class:"muted"}),ce=()=>{let ne=m.find(ge=>ge.path===L.value);$.textContent=ne?F("is #",`${xe(ne.value*ne.factor)} ${ne.unit}`):L.value?F("no number of this rig"):"";let ue=ne?.unit??"",de=ne?ne.value*ne.factor:1,Q={from:.8,to:1.2,low:.8,mode:1,high:1.2,mean:1,sd:.05};Y.replaceChildren(...Mv[H.value][1].map(ge=>{let ye=H.value==="share"?"20 %":ge in Q?`${Number((Q[ge]*de).toPrecision(4))} ${ue}`.trim():`${Number((.9*de).toPrecision(4))} ${ue}, ${Number((1.1*de).toPrecision(4))} ${ue}`;return h("input",{type:"text",value:ye,"aria-label":`${L.value||"number"}, ${ge in Q?ge:H.value}`,"data-word":ge,size:H.value==="values"?"26":"11"})}))};L.addEventListener("change",ce),H.addEventListener("change",ce);let K=h("button",{type:"button","aria-label":F("leave out #",k||F("this number"))},"×"),ee=h("tr",{},h("td",{},L),h("td",{},H),h("td",{},Y),$,h("td",{},K));K.addEventListener("click",()=>ee.remove()),ce(),n.append(ee)},x=()=>u.replaceChildren(...c.value==="iso"?[me("Class",h("select",{name:"class"},..."ABCDEFGH".split("").map(k=>h("option",k==="C"?{value:k,selected:!0}:{value:k},k))))]:Kr[c.value].map(k=>me(k[0].toUpperCase()+k.slice(1),h("input",{type:"text",value:lu[k],name:k}))));c.addEventListener("change",x);let S=async()=>{_.replaceChildren();try{m=(await ls(t.value)).numbers,s.replaceChildren(...m.map(B=>h("option",{value:B.path}))),n.replaceChildren();let k=["strut.spring.rate","strut.damper.coefficient","tyre.stiffness"].filter(B=>m.some(L=>L.path===B));for(let B of k.length?k:m.slice(0,2).map(L=>L.path))v(B)}catch(k){_.replaceChildren(vt(k))}};t.addEventListener("change",()=>{S()}),r.addEventListener("change",()=>{a.disabled=!Wf[r.value][1]});let y=k=>{let B=k.querySelector("select").value,L=Object.fromEntries([...k.querySelectorAll("input[data-word]")].map(Y=>[Y.dataset.word,Y.value.trim()])),H=Object.values(L);return B==="share"?H[0]:B==="range"?H:B==="values"?H[0].split(",").map(Y=>Y.trim()).filter(Boolean):L},T="",M="",b=async()=>{let k=Object.fromEntries([...u.querySelectorAll("[name]")].map(L=>[L.name,L.value])),B=await(await Bn("POST","/api/study",{path:p.value,was:M===p.value?T:"",rig:t.value,trial:{speed:d.value,duration:f.value,road:c.value==="iso"?`iso:${k.class}`:{kind:c.value,start:"0.2 m",...k}},design:{kind:r.value,...Wf[r.value][1]?{count:Number(a.value),seed:Number(o.value)}:{}},vary:Object.fromEntries([...n.rows].map(L=>[L.querySelector("input").value.trim(),y(L)])),metrics:l.value.split(",").map(L=>L.trim()).filter(Boolean)})).json();return T=B.digest,M=p.value,B},A=h("form",{}),O=h("button",{type:"button"},"Write the study"),N=h("button",{type:"submit",class:"main"},"Write it and begin");O.addEventListener("click",()=>{$n(O,b()).then(k=>_.replaceChildren(h("p",{class:"good"},`${k.path}: ${k.count} variants.`)),k=>_.replaceChildren(vt(k)))}),A.addEventListener("submit",k=>{k.preventDefault(),N.disabled=!0,b().then(B=>mr({kind:"sweep",study:p.value,out:g.value}).then(L=>_.replaceChildren(h("p",{class:"good"},`${B.count} variants begun.`),Un(L)))).catch(B=>_.replaceChildren(vt(B))).finally(()=>{N.disabled=!1})});let P=h("button",{type:"button"},"Another number");return P.addEventListener("click",()=>v()),A.append(h("div",{class:"form"},me("Rig",t),me("Road",c),u,me("Speed",d),me("Duration",f)),h("div",{class:"table",tabindex:"0",role:"region","aria-label":"what varies"},h("table",{},h("thead",{},h("tr",{},...["number","spread","","",""].map(k=>h("th",{scope:"col"},k)))),n)),s,P,h("div",{class:"form"},me("Design",r),me("Count",a),me("Seed",o),me("Metrics, with commas between",l)),h("div",{class:"form"},me("File of the study",p),me("Folder of the results",g),O,N),_),x(),await S(),A}async function Tv(i,e,t){let n=e?await gr(e):null,s=t??String(n?.asked.out??"");if(n&&(n.state==="running"||n.state==="cancelling")){_T(i,n,s);return}let r=await en(`/api/sweep?${ii({folder:s})}`),a=n?.title??`Sweep in ${s}`,o=h("p",{},h("a",{href:et("studies")},"All studies"));if(!r.columns.length){i.replaceChildren(h("h1",{},a),o,h("p",{class:"empty"},"No variant is finished yet."));return}let l=new fu(r.columns),c=r.variants.length,{summary:u}=r,d=h("p",{class:"state",role:"status"}),f=h("tbody",{}),p=h("button",{type:"button"},"All variants");p.addEventListener("click",()=>l.clear());let g=()=>{let m=l.chosen.flatMap((x,S)=>x?[S]:[]);d.textContent=Vi(`${m.length} of ${c} variants`)+(c<r.finished?Vi(` shown, of ${r.finished}`):"")+(l.picked>=0?Vi(`; variant ${r.variants[l.picked]} is marked`):"");let v=[...l.picked>=0?[l.picked]:[],...m.filter(x=>x!==l.picked)].slice(0,20);f.replaceChildren(...v.map(x=>{let S=h("button",{type:"button","aria-label":`mark variant ${r.variants[x]}`,"aria-pressed":String(x===l.picked)},String(r.variants[x]));return S.addEventListener("click",()=>l.pick(x===l.picked?-1:x)),h("tr",{},h("th",{scope:"row"},S),...r.columns.map(y=>h("td",{class:"right"},xe(y.values[x]))),h("td",{},...r.run?[h("a",{href:xT(r,x),"aria-label":`open variant ${r.variants[x]} as a trial`},"open as a trial")]:[]))}))};l.listen(g),g();let _=r.columns.filter(m=>!m.is_number);i.replaceChildren(h("h1",{},a),o,h("p",{class:"muted"},`${r.finished} of ${r.count} variants are finished`,u&&u.ran<r.finished?`; ${r.finished-u.ran} have no run`:"","."),...Object.entries(u?.failed??{}).map(([m,v])=>h("p",{class:"problem"},`${v.variants} without a run (variant ${v.first} first): ${m}`)),...(u?.findings??[]).map(m=>h("p",{class:"muted"},`${m.severity}: ${m.message}`)),...u?.metrics.length?[h("h2",{},"Metrics"),yT(u,_)]:[],...u?.influences.length?[h("h2",{},"What they depend on"),..._.flatMap(m=>{let v=u.metrics.find(x=>x.name===m.name);return v?[Sv(u.influences,m,v.mean)]:[]})]:[],h("h2",{},"Variants"),h("p",{class:"muted"},"Drag along an axis to keep the variants that pass there; a click on it lets all pass again."),xv(l),h("div",{class:"bar"},d,p),bv(l),..._.length?[wv(l)]:[],h("div",{class:"table",tabindex:"0",role:"region","aria-label":"chosen variants"},h("table",{},h("caption",{},"The first of the chosen variants"),h("thead",{},h("tr",{},h("th",{scope:"col"},"variant"),...r.columns.map(m=>h("th",{scope:"col",class:"right"},`${m.name} [${m.unit||"–"}]`)),h("th",{scope:"col"},""))),f)),...n?[Un(n)]:[],...n?.has_page?[_s(`/api/jobs/${n.id}/report`,"Report")]:[])}function _T(i,e,t){let n=new Gs(e);i.replaceChildren(h("h1",{},e.title),h("p",{},h("a",{href:et("studies")},"All studies")),n.element,h("p",{},h("a",{href:et("studies",{folder:t})},"What is finished by now")));let s=!1;vr(n.element,r=>{let a=r.find(o=>o.id===e.id);!a||s||(n.show(a),!(a.state==="running"||a.state==="cancelling")&&(s=!0,Tv(i,e.id,null).catch(o=>i.replaceChildren(h("h1",{},e.title),n.element,vt(o)))))})}function yT(i,e){let t=s=>e.find(r=>r.name===s)?.factor??1,n=s=>e.find(r=>r.name===s)?.unit||"–";return h("div",{class:"table",tabindex:"0",role:"region","aria-label":"metrics"},h("table",{},h("thead",{},h("tr",{},h("th",{scope:"col"},"metric"),h("th",{scope:"col"},"unit"),...["mean","standard deviation","least",...Object.keys(i.metrics[0].percentiles).map(s=>`${s} %`),"greatest"].map(s=>h("th",{scope:"col",class:"right"},s)))),h("tbody",{},...i.metrics.map(s=>h("tr",{},h("th",{scope:"row"},s.name),h("td",{},n(s.name)),...[s.mean,s.standard_deviation,s.least,...Object.values(s.percentiles).map(r=>r.value),s.greatest].map(r=>h("td",{class:"right"},xe(r*t(s.name)))))))))}function xT(i,e){let t=i.run,n={},{speed:s,duration:r}=t;for(let a of i.columns){let o=a.values[e];!a.is_number||o===null||o===void 0||(a.name==="trial.speed"?s=`${o/a.factor} m/s`:a.name==="trial.duration"?r=`${o/a.factor} s`:!a.name.startsWith("trial.")&&!a.name.startsWith("control.")&&(n[a.name]=o/a.factor))}return typeof t.road=="string"?et("ride",{vehicle:t.rig,road:t.road,speed:s,duration:r,set:JSON.stringify(n)}):et("trial",{rig:t.rig,road:JSON.stringify(t.road),speed:s,duration:r,set:JSON.stringify(n)})}var Ws=320,Cl=62,pu=40,mu=10,Av=14,Cv=["strut.deflection","strut.velocity"],gu=class{constructor(e){this.lacking=e;for(let t of[this.across,this.upward])t.addEventListener("change",()=>this.begin());new ResizeObserver(([t])=>{this.width=Math.floor(t.contentRect.width),this.redraw()}).observe(this.element),new IntersectionObserver(t=>{this.isSeen=t.some(n=>n.isIntersecting),this.draw()},{rootMargin:"100px"}).observe(this.element),jn(()=>this.redraw())}lacking;canvas=h("canvas",{role:"img"});across=h("select",{});upward=h("select",{});values=h("output",{});element=h("section",{class:"phase","aria-label":F("Phase plot")},h("h2",{},F("Phase plot")),h("div",{class:"form"},me(F("Across"),this.across),me(F("Upward"),this.upward),this.values),this.canvas);curves=h("canvas");model=null;store=null;time=0;known="";width=0;isSeen=!1;isOld=!0;frame=0;waiting=0;wanted="";get channels(){return[this.across,this.upward].map((e,t)=>e.value||Cv[t])}show(e,t){this.model=e,this.store=t;let n=e.scenes[0].panes.filter(s=>!s.name.startsWith("Δ")).map(s=>s.name);if(n.join()!==this.known){this.known=n.join();let s=[this.across.value,this.upward.value];[this.across,this.upward].forEach((r,a)=>{r.replaceChildren(...n.map(o=>h("option",{value:o},o))),r.value=[s[a],Cv[a],n[Math.min(a,n.length-1)]].find(o=>n.includes(o))??""})}this.begin()}begin(){let e=this.channels.join();this.chosen()?.every(t=>t.curves.length)?this.redraw():e!==this.wanted&&(this.wanted=e,this.lacking())}mark(e){this.time=e,this.draw()}chosen(){let[e,t]=[this.across,this.upward].map(n=>this.model?.scenes[0]?.panes.find(s=>s.name===n.value));return e&&t?[e,t]:null}redraw(){this.isOld=!0,this.draw()}draw(){clearTimeout(this.waiting),this.isSeen?this.frame||(this.frame=requestAnimationFrame(()=>{this.frame=0,this.drawn()})):this.waiting=setTimeout(()=>this.drawn(),400)}drawn(){let{width:e,store:t}=this,n=this.model?.scenes[0],s=this.chosen();if(!n||!t||!s||e<100)return;let[r,a]=s,o=Math.min(e,720),l=r.curves.flatMap(y=>{let T=a.curves.find(M=>M.role===y.role);return T?[{role:y.role,label:y.label,x:t.get(y.y),y:t.get(T.y)}]:[]}),[c,u]=Rv(l.map(y=>y.x)),[d,f]=Rv(l.map(y=>y.y)),p=t.get(n.x),g=y=>Cl+(y-c)/(u-c)*(o-Cl-Av),_=y=>mu+(f-y)/(f-d)*(Ws-mu-pu);this.isOld&&this.drawCurves(o,g,_,s,l,[c,u],[d,f]),this.isOld=!1;let m=this.canvas.getContext("2d",{willReadFrequently:!0});(this.canvas.width!==o||this.canvas.height!==Ws)&&(this.canvas.width=o,this.canvas.height=Ws),m.clearRect(0,0,o,Ws),m.drawImage(this.curves,0,0);for(let{role:y,x:T,y:M}of[...l].reverse()){let b=Li(p,T,this.time),A=Li(p,M,this.time);Number.isFinite(b)&&Number.isFinite(A)&&(m.fillStyle=xt(y),m.beginPath(),m.arc(g(b),_(A),5,0,2*Math.PI),m.fill())}let v=l[0]?Li(p,l[0].x,this.time):NaN,x=l[0]?Li(p,l[0].y,this.time):NaN,S=s.map(y=>y.curves[0]?t.step(y.curves[0].y):0);this.values.textContent=`${vo(v,S[0])} ${r.unit}, ${vo(x,S[1])} ${a.unit}`,this.canvas.setAttribute("aria-label",`${a.name} ${F("over")} ${r.name}`)}drawCurves(e,t,n,[s,r],a,[o,l],[c,u]){let d=this.curves.getContext("2d",{willReadFrequently:!0});this.curves.width=e,this.curves.height=Ws,d.font="12px system-ui, sans-serif",d.fillStyle=xt("muted"),d.strokeStyle=xt("line"),d.lineWidth=1,d.textAlign="center";for(let f of so(o,l,6))d.beginPath(),d.moveTo(t(f),mu),d.lineTo(t(f),Ws-pu),d.stroke(),d.fillText(Ml(f),t(f),Ws-pu+15);d.textAlign="right";for(let f of so(c,u,5))d.beginPath(),d.moveTo(Cl,n(f)),d.lineTo(e-Av,n(f)),d.stroke(),d.fillText(Ml(f),Cl-5,n(f)+4);d.fillStyle=xt("ink"),d.textAlign="center",d.fillText(`${s.name} [${s.unit||"–"}]`,.5*(Cl+e),Ws-8),d.save(),d.translate(12,.5*(mu+Ws-pu)),d.rotate(-Math.PI/2),d.fillText(`${r.name} [${r.unit||"–"}]`,0,0),d.restore();for(let{role:f,x:p,y:g}of[...a].reverse()){d.strokeStyle=xt(f),d.lineWidth=1.4,d.beginPath();let _=!1;for(let m=0;m<p.length;m++){let v=p[m],x=g[m];if(v===null||x===null||v===void 0||x===void 0){_=!1;continue}_?d.lineTo(t(v),n(x)):d.moveTo(t(v),n(x)),_=!0}d.stroke()}}};function Rv(i){let e=1/0,t=-1/0;for(let s of i)for(let r=0;r<s.length;r++){let a=s[r];a!=null&&Number.isFinite(a)&&(a<e&&(e=a),a>t&&(t=a))}if(!(t>e))return[(Number.isFinite(e)?e:0)-1,(Number.isFinite(e)?e:0)+1];let n=.05*(t-e);return[e-n,t+n]}var Lv={label:"Trial",show:wT},bT=["strut.spring.rate","strut.damper.coefficient","strut.damper.bump_coefficient","strut.damper.rebound_coefficient","tyre.stiffness","sprung.mass","unsprung.mass"];async function wT(i,e){let t=e.get("rig");if(!t){await xr(i,"trial",F("Trial"),"rig",!0,Ui,e.get("record")?{record:e.get("record")}:{});return}let n=await ls(t),s=h("select",{},...Object.keys(Kr).map(O=>h("option",{value:O},F(O.replace("-"," "))))),r=h("span",{class:"sizes"}),a=Pv(e.get("road"));a.kind&&a.kind in Kr&&(s.value=a.kind);let o=h("input",{type:"text",value:e.get("speed")??(n.name.includes("kart")?"1.95 m/s":"30 km/h")}),l=h("input",{type:"text",value:e.get("duration")??"1.5 s"}),c=()=>r.replaceChildren(...Kr[s.value].map(O=>{let N=h("input",{type:"text",value:a[O]??lu[O],name:O});return N.addEventListener("change",()=>{S.ask()}),me(F(O[0].toUpperCase()+O.slice(1)),N)})),u=new to(n,bT,()=>{S.ask()},Pv(e.get("set"))),d=()=>({rig:t,changes:u.changes,speed:o.value,duration:l.value,road:{kind:s.value,start:a.start??"0.2 m",...Object.fromEntries([...r.querySelectorAll("input")].map(O=>[O.name,O.value]))}}),{entries:f}=await Ln(),p=h("select",{},...[["time",F("time")],["spectra",F("frequency (spectra)")]].map(([O,N])=>h("option",{value:O},N))),g=h("select",{},h("option",{value:""},F("none")),...f.filter(O=>O.kind==="record").map(({path:O})=>h("option",{value:O,...O===e.get("record")?{selected:!0}:{}},O))),_=h("input",{type:"text",value:"0 s"}),m=me(F("Where it begins"),_),v=()=>{m.hidden=!g.value},x=new gu(()=>{S.ask()}),S=new eu(O=>da("simulate",{...d(),spectra:p.value==="spectra",measured:g.value,begins:_.value,numbers:[...O,...x.channels]}));S.shown=(O,N)=>{x.element.hidden=p.value!=="time",p.value==="time"&&x.show(O,N)},S.moved=O=>{p.value==="time"&&x.mark(O)};for(let O of[p,g,_])O.addEventListener("change",()=>{v(),S.ask()});v();let y=h("input",{type:"text",size:"40",value:`${t.replace(/\.toml$/,"").split("/").pop()} ${new Date().toISOString().slice(0,16).replace("T"," ").replace(":",".")}`}),T=h("span",{"aria-live":"polite"}),M=h("button",{type:"submit"},F("Keep it")),b=h("form",{class:"form"},me(F("Keep this run as"),y),M,T);b.addEventListener("submit",O=>{O.preventDefault(),$n(M,Bn("POST","/api/keep",{...d(),title:y.value})).then(async N=>{let{path:P}=await N.json();T.replaceChildren(F("Kept as "),h("a",{href:et("record",{path:P})},P),". ",h("a",{href:et("project")},F("Compare it in the project")))},N=>T.replaceChildren(vt(N)))}),s.addEventListener("change",()=>{c(),S.ask()});for(let O of[o,l])O.addEventListener("change",()=>{S.ask()});c(),yr(S);let A=h("div",{class:"form"},me(F("Obstacle"),s),r,me(F("Speed"),o),me(F("Duration"),l),me(F("Curves over"),p),me(F("Beside a recording"),g),m);i.replaceChildren(h("h1",{},F("# over an obstacle",t)),h("div",{class:"bench"},h("div",{class:"controls",role:"region","aria-label":F("What is run")},A,u.element),h("div",{},S.element,x.element,h("h2",{},F("Keep this run")),b))),await S.ask()}function Pv(i){try{return JSON.parse(i??"{}")??{}}catch{return{}}}var Rl={project:fv,rig:_v,trial:Lv,kinematics:dv,record:mv,campaign:rv,ride:gv,inspection:ov,studies:Ev,jobs:lv};async function Iv(){let[i="",e=""]=location.hash.replace(/^#\//,"").split("?"),t=i in Rl?i:"project";mp(),yr(null);let n=h("div",{},h("p",{class:"muted"},"loading …"));document.querySelectorAll("#pages a").forEach(s=>{s.dataset.page===t?s.setAttribute("aria-current","page"):s.removeAttribute("aria-current")}),document.title=`${F(Rl[t].label)} – jounce workbench`,document.getElementById("main").replaceChildren(n);try{await Rl[t].show(n,new URLSearchParams(e))}catch(s){n.replaceChildren(h("h1",{},Rl[t].label),vt(s),h("p",{},h("a",{href:et("project")},"Back to the project")))}n.isConnected&&(document.documentElement.dataset.ready=t)}document.documentElement.classList.add("live");document.getElementById("pages").append(...Object.entries(Rl).map(([i,{label:e}])=>h("a",{href:et(i),"data-page":i},e)));document.querySelector("header").append(dp(),gp());document.getElementById("pages").setAttribute("aria-label",F("Pages"));document.querySelector(".skip").textContent=F("To the content");addEventListener("hashchange",()=>{delete document.documentElement.dataset.ready,Iv()});Ln().then(({name:i})=>{document.getElementById("project").textContent=i},()=>{});Iv();return Kv(ST);})();
