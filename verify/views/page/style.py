"""The style sheet of the page: system fonts, both colour schemes, a phone, a screen, paper."""

from __future__ import annotations

from verify.views.plots.drawing import SCHEMES


def _colours(scheme: str) -> str:
    return ";".join(f"--{name}:{colour}" for name, colour in SCHEMES[scheme].items())


STYLE = (
    ":root{color-scheme:light dark;--tint:#fdeeda;--soft:#f4f5f6;--line:#dfe2e6;--link:#2257a0;"
    + _colours("light")
    + "}@media screen and (prefers-color-scheme:dark){"
    + ":root{--tint:#3a2a17;--soft:#1c2229;--line:#333b44;--link:#9dbcf2;"
    + _colours("dark")
    + "}}"
    + """
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%;scroll-padding-top:1rem}
body{margin:0;background:var(--paper);color:var(--ink);
 font:1rem/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
header,main{max-width:64rem;margin:0 auto;padding:0 1.1rem}
header{padding-top:1.6rem}
header p{color:var(--ink);opacity:.8;margin:.2rem 0 1rem;max-width:46rem}
h1{font-size:1.75rem;line-height:1.2;margin:0;letter-spacing:-.01em;text-wrap:balance}
h2{font-size:1.3rem;line-height:1.25;margin:3rem 0 .8rem;padding-top:.9rem;
 border-top:1px solid var(--line)}
h3{font-size:1.02rem;line-height:1.3;margin:1.6rem 0 .5rem}
p,ul{max-width:46rem}
a{color:var(--link)}
nav{display:flex;flex-wrap:wrap;gap:.3rem 1.1rem;margin:1.4rem 0 0;font-size:.93rem}
code,pre{font-family:ui-monospace,SFMono-Regular,Menlo,Consolas,monospace;font-size:.85em}
code{overflow-wrap:anywhere}
td code{overflow-wrap:break-word}
.number code{overflow-wrap:anywhere}
pre{background:var(--soft);border-radius:.4rem;padding:.8rem 1rem;overflow-x:auto;max-width:100%;
 white-space:pre-wrap}
pre code{font-size:.85rem}
sub,sup{line-height:0;font-size:.75em}
math{font-size:1.05em;
 font-family:VerifyMath,"STIX Two Math","Latin Modern Math","Cambria Math",math,serif}
.claim math,td math,.repair math{math-style:normal}
data{white-space:nowrap}
@media screen{.number:not([open])::details-content{display:none}}
.claim,.repair{overflow-x:auto;overflow-y:hidden}
.claim{padding:.35rem 0}
.claim .math,.claim{line-height:2}
.repair .math{display:block;line-height:2;padding:.3rem 0}
.facts{list-style:none;padding:0;margin:1rem 0;display:grid;gap:.6rem;max-width:58rem}
.facts li{display:grid;grid-template-columns:12rem 1fr;gap:.8rem;align-items:baseline}
.facts .verdict{justify-self:start;white-space:nowrap}
.verdict{display:inline-block;font-size:.8rem;line-height:1;font-weight:600;padding:.3rem .5rem;
 border-radius:.3rem;border:1px solid currentColor;text-align:center}
.button{display:inline-block;background:var(--link);color:var(--paper);font-weight:600;
 padding:.5rem 1rem;border-radius:.4rem;text-decoration:none;margin-right:.4rem}
.hold{font-size:.9rem;display:inline-block;margin:0 0 .4rem}
figure:has(.hold :checked) .moving *{animation-play-state:paused!important}
@media (prefers-reduced-motion:reduce){.moving *{animation:none!important}.hold{display:none}}
.proved{color:var(--proved)}.undecided{color:var(--faint);border-style:dashed}
.refuted{color:var(--ink);border-color:var(--refuted);background:var(--tint)}
.theorem{background:var(--soft);border-left:.25rem solid var(--proved);border-radius:.4rem;
 padding:.9rem 1.1rem;margin:1.2rem 0;max-width:52rem}
.theorem h3{margin:0 0 .3rem}.theorem p{margin:0}
.grid,.few{margin:.6rem 0;border:1px solid var(--line);border-radius:.4rem}
table{border-collapse:collapse;width:100%;font-size:.9rem;line-height:1.4;
 font-variant-numeric:tabular-nums}
th,td{text-align:left;vertical-align:top;padding:.45rem .6rem;border-bottom:1px solid var(--line)}
th{background:var(--soft);font-weight:600}
tbody tr:last-child td{border-bottom:0}
td{max-width:26rem}
td .verdict{white-space:nowrap}
.rows{margin:.6rem 0}
.rows thead{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}
.rows table,.rows tbody{display:block}
.rows tr{display:grid;grid-template-columns:6.5rem minmax(0,1fr);gap:.1rem .8rem;
 padding:.55rem .2rem;border-bottom:1px solid var(--line)}
.rows td{display:block;border:0;padding:0;max-width:none;min-width:0;overflow-x:auto;
 overflow-y:hidden;grid-column:2}
.rows td:first-child{grid-column:1;grid-row:1}
.rows.rows td:nth-child(4) math{line-height:2}
.witness{overflow-wrap:anywhere}
.top{position:fixed;right:.7rem;bottom:.7rem;padding:.3rem .6rem;border-radius:.4rem;
 background:var(--soft);border:1px solid var(--line);font-size:.85rem;text-decoration:none}
.curve:target{stroke:var(--ink);stroke-width:4;fill:var(--ink)}
svg a:hover rect:first-of-type,svg a:focus rect:first-of-type{stroke-width:3}
.entry{display:block;padding:.18rem 0 0 1rem}
details{margin:.6rem 0}
summary{cursor:pointer}
details>summary{font-weight:600}
.number{display:inline-block;margin:0;vertical-align:top;max-width:100%}
.number>summary{font-weight:400;white-space:nowrap;list-style:none;
 text-decoration:underline dotted var(--faint);text-underline-offset:.2em}
.number>summary::-webkit-details-marker{display:none}
.steps{display:grid;gap:.9rem;grid-template-columns:repeat(auto-fill,minmax(min(100%,27rem),1fr))}
article{border:1px solid var(--line);border-radius:.5rem;padding:.8rem 1rem;min-width:0;
 break-inside:avoid}
article p{margin:.35rem 0}
article dl{display:flex;flex-wrap:wrap;gap:.3rem 1.4rem;margin:.4rem 0}
dt{font-size:.8rem;color:var(--ink);opacity:.75}
dd{margin:0;font-variant-numeric:tabular-nums}
.repair{margin-top:.5rem;border-top:1px solid var(--line);padding-top:.45rem;font-size:.93rem}
figure{margin:1.4rem 0 2.2rem;break-inside:avoid}
figure h3{margin:0 0 .4rem}
.panels{display:grid;gap:.6rem;grid-template-columns:repeat(auto-fit,minmax(min(100%,19rem),1fr))}
.panels svg{width:100%;max-width:36rem;height:auto;display:block}
figcaption{font-size:.9rem;line-height:1.5;max-width:52rem;margin-top:.5rem}
@media screen and (max-width:52rem){
 .grid{border:0;border-top:1px solid var(--line);border-radius:0}
 .grid thead{display:none}
 .grid table,.grid tbody,.grid tr{display:block}
 .grid tr{padding:.5rem 0;border-bottom:1px solid var(--line)}
 .grid td{display:flow-root;border:0;padding:.1rem 0 .1rem 6.4rem;max-width:none;
  overflow-wrap:anywhere}
 .grid td code{overflow-wrap:anywhere}
 .grid td::before{content:attr(data-of);float:left;width:6rem;margin-left:-6.4rem;font-size:.85em;
  color:var(--ink);opacity:.75}
 .grid td:empty{display:none}
}
@media screen and (max-width:40rem){
 .facts li{grid-template-columns:1fr;gap:.2rem}
 .rows tr{grid-template-columns:minmax(0,1fr)}
 .rows td,.rows td:first-child{grid-column:1;grid-row:auto}
 article{padding:.7rem .8rem}
 .grid td math{font-size:.95em}
}
@media print{
 :root{color-scheme:light}
 body{font-size:10pt}
 header,main{max-width:none;padding:0}
 nav,.top,.hold{display:none}
 .button{background:none;color:var(--ink);padding:0;margin:0}
 .moving *{animation:none!important}
 details::details-content{content-visibility:visible;display:block}
 .verdict{white-space:nowrap;break-inside:avoid}
 .rows tbody{columns:2;column-gap:1.5rem}
 .rows tr{break-inside:avoid;grid-template-columns:5.5rem minmax(0,1fr)}
 .rows td{overflow:visible}
 h2{break-after:avoid}h3{break-after:avoid}
 .grid{border:0}
 table{font-size:8pt}
 td{max-width:none;overflow-wrap:anywhere}
 td math{font-size:.9em}td .verdict{padding:.15rem .3rem}
 .number>summary{white-space:normal}
 .claim,.repair{overflow:visible}
 .panels{grid-template-columns:repeat(2,1fr)}
 tr{break-inside:avoid}
}
"""
)
