"""The two papers rebuilt with the public interface only: their rigs, benches and figures, beside what is correct."""
