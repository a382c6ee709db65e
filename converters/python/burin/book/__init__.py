"""`burin book`: the figures of a manual, made from one file and made anew where what they show has changed. The directive of
Sphinx (burin.sphinx) draws by the same code. kernel/docs/manuals.md explains both."""
