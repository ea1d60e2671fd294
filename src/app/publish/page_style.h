// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::app {

/// The style of frana's pages: plain on the screen, black on white on A4. On paper the first section fills its page,
/// two maps have room on a page, no row of a table and no picture is divided by a page break, heads of tables are
/// repeated, and what is folded is left out. No picture is higher than half a page, so that a page whose next picture
/// does not fit is more than half full.
inline constexpr const char* k_page_style = R"(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { font: 15px/1.45 "DejaVu Sans", Verdana, Arial, sans-serif; color: #1a1a1a; background: #fff;
  max-width: 60rem; margin: 1.5rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; line-height: 1.2; margin: 0 0 .2rem; }
h2 { font-size: 1.2rem; margin: 2rem 0 .6rem; border-bottom: 1px solid #999; }
h3 { font-size: 1rem; margin: 1.2rem 0 .4rem; }
h1, h2, h3, p, figcaption, summary { overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; font-size: .85rem; margin: .4rem 0; }
th, td { text-align: left; vertical-align: top; padding: .2rem .5rem; border-bottom: 1px solid #ddd;
  overflow-wrap: anywhere; }
th { font-weight: bold; border-bottom-color: #888; }
.n { text-align: right; font-variant-numeric: tabular-nums; }
td.n { white-space: nowrap; } td.u { overflow-wrap: normal; } td.u { padding-left: 0; }
.soft { color: #555; }
table.keys { table-layout: fixed; } table.keys th { width: 18%; } table.keys th:nth-child(2) { width: 19%; }
table.keys th:nth-child(3) { width: 9%; } table.keys th:last-child { width: auto; }
tr.given td { font-weight: bold; } tr.given td:last-child { font-weight: normal; }
.answer p { margin: .4rem 0; }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(22rem, 100%), 1fr)); gap: .4rem 1.6rem;
  align-items: start; }
.columns > * { min-width: 0; }
figure { margin: .6rem 0; } figcaption { font-size: .85rem; color: #333; }
.small { font-size: .8rem; color: #444; }
.warning { border-left: .4rem solid #d55e00; background: #fdf1e7; padding: .3rem .8rem; margin: .4rem 0; }
.good { border-left: .4rem solid #009e73; background: #eaf7f2; padding: .3rem .8rem; }
img, svg { display: block; width: 100%; height: auto; border: 1px solid #ccc; }
.swatch { display: inline-block; width: 1em; height: 1em; border: 1px solid #666; vertical-align: -.15em; }
summary { cursor: pointer; font-weight: bold; margin: .6rem 0; }
@page { size: A4; margin: 13mm 15mm 16mm; font: 7.5pt "DejaVu Sans", Verdana, sans-serif; color: #555;
  @bottom-right { content: counter(page) " / " counter(pages); } }
@media print {
  body { max-width: none; margin: 0; padding: 0; font-size: 8.5pt; line-height: 1.35; }
  h1 { font-size: 15pt; } h2 { font-size: 11.5pt; margin: 5mm 0 2mm; } h3 { font-size: 9pt; margin: 3mm 0 1mm; }
  h1, h2, h3 { break-after: avoid; }
  table { font-size: 7.5pt; margin: 1mm 0; } th, td { padding: .5mm 1.5mm; }
  table.keys { font-size: 6.3pt; line-height: 1.2; } table.keys td { padding: .2mm 1mm; }
  thead { display: table-header-group; }
  tr, .columns, figure, img, svg, .warning { break-inside: avoid; }
  p { orphans: 3; widows: 3; }
  .small, figcaption { font-size: 7.5pt; }
  .columns { grid-template-columns: 1fr 1fr; gap: 1mm 6mm; }
  figure { margin: 1.5mm 0; }
  figure svg { width: auto; max-width: 100%; max-height: 44mm; }
  figure img { width: auto; max-width: 100%; max-height: 110mm; }
  .warning, .good { background: none; border-left-width: 1.5mm; padding: .3mm 2mm; margin: 1mm 0; }
  details { display: none; }
  a { color: inherit; text-decoration: none; }
  .answer { display: flex; flex-direction: column; min-height: 265mm; }
  .answer.plain { display: block; min-height: 0; }
  .answer p { margin: 1mm 0; }
  .answer figure { flex: 1 1 95mm; min-height: 95mm; max-height: 140mm; display: flex; flex-direction: column; }
  .answer figure img { flex: 1 1 0; min-height: 0; max-height: none; object-fit: contain; border: 0; }
  figure svg.page { width: 180mm; max-width: none; max-height: none; }
  figure img.page, .answer figure img.page { flex: none; width: 180mm; max-width: none; max-height: none; border: 0; }
}
)";

}  // namespace frana::app
