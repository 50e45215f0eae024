"""How the page of a report looks."""

from typing import Final

STYLE: Final = """
:root { color-scheme: light; }
body { margin: 0; background: #eaf2f5; color: #1d3441;
  font: 15px/1.5 Inter, "Segoe UI", Helvetica, Arial, sans-serif; }
main { max-width: 1040px; margin: 0 auto; padding: 32px 28px 64px; }
h1 { font-size: 34px; margin: 0 0 6px; letter-spacing: -.5px; color: #12305a; }
h2 { font-size: 26px; margin: 0; color: #12305a; }
h3 { font-size: 18px; margin: 30px 0 8px; color: #12305a; }
h4 { font-size: 15px; margin: 26px 0 6px; color: #1f6f9f; }
p { margin: 6px 0; } .lead { max-width: 760px; }
section { background: #fff; border: 1px solid #d5e4ea; border-radius: 10px; margin-top: 32px; padding: 26px 28px; }
main section { margin-left: -28px; margin-right: -28px; }
.species { display: flex; justify-content: space-between; align-items: center; gap: 24px; }
.species svg { flex: none; }
svg { display: block; max-width: 100%; height: auto; }
figure { margin: 6px 0 0; display: flex; flex-wrap: wrap; gap: 12px; justify-content: space-between; }
figcaption, .caption { font-size: 12.5px; color: #6d8794; max-width: 820px; }
figcaption { flex: 1 0 100%; }
.pair { display: flex; gap: 12px; align-items: flex-start; width: 100%; }
table { border-collapse: collapse; width: 100%; margin: 8px 0 16px; font-size: 13px; background: #fff; }
th, td { text-align: left; padding: 4px 9px; border-bottom: 1px solid #e3edf1; font-variant-numeric: tabular-nums; }
thead th { color: #6d8794; font-weight: 600; border-bottom: 2px solid #c4d6de; vertical-align: bottom; }
tbody th { font-weight: 500; }
td:not(.living) { white-space: nowrap; }
.living { color: #6d8794; font-size: 12px; }
.in b, .out b { font-size: 10.5px; font-weight: 600; padding: 0 5px; border-radius: 7px; margin-left: 3px; }
.in b { color: #0f6b4f; background: #d8f0e6; }
.out b { color: #9a2f1c; background: #fbe0d9; }
td.out { color: #9a2f1c; }
.all svg { margin: auto; } .all { margin-top: 18px; border-radius: 10px; overflow: hidden; }
.warnings { color: #9a2f1c; margin: 0; padding-left: 20px; }
a { color: #1f6f9f; }
@media (max-width: 800px) { .pair, .species { flex-direction: column; } main { padding: 16px; } }
@media print { body { background: #fff; } section { border: 0; break-before: page; } }
"""
