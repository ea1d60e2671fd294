// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_ground_warning_words = std::to_array<WordRow>({
    // Terrain: src/app/input/check_terrain.cpp, prepare_terrain.cpp.
    {"{1} (row {2}, column {3})", "{1} (riga {2}, colonna {3})", "{1} (Zeile {2}, Spalte {3})",
     "{1} (ligne {2}, colonne {3})", "{1} (fila {2}, columna {3})"},
    {"{1} m at {2}", "{1} m a {2}", "{1} m bei {2}", "{1} m en {2}", "{1} m en {2}"},
    {"If it is nodata, set terrain.nodata-value; if the unit differs, set terrain.vertical-unit or convert the file",
     "Se è un valore senza dato, impostare terrain.nodata-value; se l’unità è un’altra, impostare "
     "terrain.vertical-unit o convertire il file",
     "Bei einem Wert für fehlende Daten terrain.nodata-value setzen; bei anderer Einheit terrain.vertical-unit setzen "
     "oder die Datei umwandeln",
     "S’il s’agit d’une valeur sans donnée, fixer terrain.nodata-value\u202F; si l’unité est autre, fixer "
     "terrain.vertical-unit ou convertir le fichier",
     "Si es un valor sin dato, fije terrain.nodata-value; si la unidad es otra, fije terrain.vertical-unit o convierta "
     "el archivo"},
    {"DTM: the highest elevation is {1} m at {2}, higher than any mountain. {3}",
     "DTM: la quota massima è {1} m a {2}, più alta di ogni montagna. {3}",
     "DGM: die größte Höhe ist {1} m bei {2}, höher als jeder Berg. {3}",
     "MNT\u202F: l’altitude maximale est de {1} m en {2}, plus haute que toute montagne. {3}",
     "MDT: la cota máxima es {1} m en {2}, más alta que cualquier montaña. {3}"},
    {"DTM: the lowest elevation is {1} m at {2}, lower than any dry ground. {3}",
     "DTM: la quota minima è {1} m a {2}, più bassa di ogni terra emersa. {3}",
     "DGM: die kleinste Höhe ist {1} m bei {2}, tiefer als jedes trockene Land. {3}",
     "MNT\u202F: l’altitude minimale est de {1} m en {2}, plus basse que toute terre émergée. {3}",
     "MDT: la cota mínima es {1} m en {2}, más baja que cualquier tierra emergida. {3}"},
    {"DTM: half of the ground is steeper than {1} degrees: elevations and eastings may be in different units. Check "
     "terrain.vertical-unit and the coordinate reference system",
     "DTM: metà del terreno è più ripida di {1} gradi: quote e coordinate est possono essere in unità diverse. "
     "Controllare terrain.vertical-unit e il sistema di riferimento",
     "DGM: die Hälfte des Geländes ist steiler als {1} Grad: Höhen und Rechtswerte können verschiedene Einheiten "
     "haben. terrain.vertical-unit und das Koordinatenbezugssystem prüfen",
     "MNT\u202F: la moitié du terrain est plus raide que {1} degrés\u202F: altitudes et abscisses peuvent être dans "
     "des unités différentes. Vérifier terrain.vertical-unit et le système de coordonnées",
     "MDT: la mitad del terreno es más empinada que {1} grados: cotas y coordenadas este pueden estar en unidades "
     "distintas. Compruebe terrain.vertical-unit y el sistema de referencia"},
    {"DTM: {1} single cell stands more than {2} m above or below all eight neighbours; they deflect the flow and "
     "falsify its speed: {3}. Repair the DTM there (a mast, a bird, noise, undeclared nodata)",
     "DTM: {1} singola cella sta oltre {2} m sopra o sotto tutte le otto vicine; devia il flusso e ne falsa la "
     "velocità: {3}. Correggere lì il DTM (un traliccio, un uccello, rumore, valori senza dato non dichiarati)",
     "DGM: {1} einzelne Zelle liegt mehr als {2} m über oder unter allen acht Nachbarn; sie lenkt den Strom ab und "
     "verfälscht seine Geschwindigkeit: {3}. Das DGM dort ausbessern (ein Mast, ein Vogel, Rauschen, nicht erklärte "
     "Fehlwerte)",
     "MNT\u202F: {1} maille isolée dépasse de plus de {2} m, vers le haut ou le bas, ses huit voisines\u202F; elle "
     "dévie l’écoulement et fausse sa vitesse\u202F: {3}. Corriger le MNT à cet endroit (un pylône, un oiseau, du "
     "bruit, des valeurs sans donnée non déclarées)",
     "MDT: {1} celda aislada está más de {2} m por encima o por debajo de sus ocho vecinas; desvía el flujo y falsea "
     "su velocidad: {3}. Corrija ahí el MDT (un poste, un ave, ruido, valores sin dato no declarados)"},
    {"DTM: {1} single cells stand more than {2} m above or below all eight neighbours; they deflect the flow and "
     "falsify its speed: {3}. Repair the DTM there (a mast, a bird, noise, undeclared nodata)",
     "DTM: {1} singole celle stanno oltre {2} m sopra o sotto tutte le otto vicine; deviano il flusso e ne falsano la "
     "velocità: {3}. Correggere lì il DTM (un traliccio, un uccello, rumore, valori senza dato non dichiarati)",
     "DGM: {1} einzelne Zellen liegen mehr als {2} m über oder unter allen acht Nachbarn; sie lenken den Strom ab und "
     "verfälschen seine Geschwindigkeit: {3}. Das DGM dort ausbessern (ein Mast, ein Vogel, Rauschen, nicht erklärte "
     "Fehlwerte)",
     "MNT\u202F: {1} mailles isolées dépassent de plus de {2} m, vers le haut ou le bas, leurs huit voisines\u202F; "
     "elles dévient l’écoulement et faussent sa vitesse\u202F: {3}. Corriger le MNT à ces endroits (un pylône, un "
     "oiseau, du bruit, des valeurs sans donnée non déclarées)",
     "MDT: {1} celdas aisladas están más de {2} m por encima o por debajo de sus ocho vecinas; desvían el flujo y "
     "falsean su velocidad: {3}. Corrija ahí el MDT (un poste, un ave, ruido, valores sin dato no declarados)"},
    {"DTM: {1} cells are 0 and stand like walls against their neighbours; they were read as elevations. If they are "
     "nodata, set terrain.nodata-value = 0",
     "DTM: {1} celle valgono 0 e stanno come muri contro le vicine; sono state lette come quote. Se sono senza dato, "
     "impostare terrain.nodata-value = 0",
     "DGM: {1} Zellen sind 0 und stehen wie Wände gegen ihre Nachbarn; sie wurden als Höhen gelesen. Sind es "
     "Fehlwerte, terrain.nodata-value = 0 setzen",
     "MNT\u202F: {1} mailles valent 0 et se dressent comme des murs contre leurs voisines\u202F; elles ont été lues "
     "comme des altitudes. Si elles sont sans donnée, fixer terrain.nodata-value = 0",
     "MDT: {1} celdas valen 0 y se alzan como muros frente a sus vecinas; se leyeron como cotas. Si no tienen dato, "
     "fije terrain.nodata-value = 0"},
    {"{1} cells of the working grid have no elevation; {2} of them were interpolated (nodata-policy = fill)",
     "{1} celle della griglia di lavoro non hanno quota; {2} di esse sono state interpolate (nodata-policy = fill)",
     "{1} Zellen des Arbeitsgitters haben keine Höhe; {2} davon wurden interpoliert (nodata-policy = fill)",
     "{1} mailles de la grille de travail n’ont pas d’altitude\u202F; {2} d’entre elles ont été interpolées "
     "(nodata-policy = fill)",
     "{1} celdas de la malla de trabajo no tienen cota; {2} de ellas se interpolaron (nodata-policy = fill)"},
    {"{1} to {2} m, slope {3} degrees on average, {4} at most",
     "da {1} a {2} m, pendenza in media {3} gradi, al massimo {4}",
     "{1} bis {2} m, Neigung im Mittel {3} Grad, höchstens {4}",
     "{1} à {2} m, pente de {3} degrés en moyenne, {4} au plus",
     "{1} a {2} m, pendiente de {3} grados en promedio, {4} como máximo"},
    {"Elevations in feet or decimetres read as metres look like this: check the elevations above against a map, "
     "terrain.vertical-unit, and the DTM for steps and towers",
     "Quote in piedi o decimetri lette come metri hanno questo aspetto: confrontare le quote qui sopra con una carta, "
     "controllare terrain.vertical-unit, e cercare gradini e torri nel DTM",
     "So sehen Höhen in Fuß oder Dezimetern aus, die als Meter gelesen wurden: die Höhen oben mit einer Karte "
     "vergleichen, terrain.vertical-unit prüfen, das DGM nach Stufen und Türmen absuchen",
     "Des altitudes en pieds ou en décimètres lues comme des mètres se présentent ainsi\u202F: comparer les altitudes "
     "ci-dessus à une carte, vérifier terrain.vertical-unit, et chercher des marches et des tours dans le MNT",
     "Cotas en pies o decímetros leídas como metros tienen este aspecto: compare las cotas de arriba con un mapa, "
     "compruebe terrain.vertical-unit y busque escalones y torres en el MDT"},
    {"the release is nearly vertical: {1}. {2}", "l’area di distacco è quasi verticale: {1}. {2}",
     "die Anrissfläche ist fast senkrecht: {1}. {2}", "la zone de départ est presque verticale\u202F: {1}. {2}",
     "el área de inicio es casi vertical: {1}. {2}"},
    {"the release is nearly flat: {1}. Check that perimeter and DTM belong to the same place (coordinate reference "
     "systems), that the elevations are in metres (terrain.vertical-unit), and that the DTM has its elevations there",
     "l’area di distacco è quasi piana: {1}. Controllare che perimetro e DTM siano dello stesso luogo (sistemi di "
     "riferimento), che le quote siano in metri (terrain.vertical-unit) e che il DTM abbia lì le sue quote",
     "die Anrissfläche ist fast eben: {1}. Zu prüfen ist, ob Umriss und DGM zum selben Ort gehören "
     "(Koordinatenbezugssysteme), ob die Höhen in Metern sind (terrain.vertical-unit) und ob das DGM dort seine Höhen "
     "hat",
     "la zone de départ est presque plate\u202F: {1}. Vérifier que périmètre et MNT sont du même lieu (systèmes de "
     "coordonnées), que les altitudes sont en mètres (terrain.vertical-unit) et que le MNT y a ses altitudes",
     "el área de inicio es casi llana: {1}. Compruebe que perímetro y MDT sean del mismo lugar (sistemas de "
     "referencia), que las cotas estén en metros (terrain.vertical-unit) y que el MDT tenga ahí sus cotas"},
    {"the release is held by friction: its ground, {1}, is nowhere as steep as the slope of {2} degrees that its "
     "friction holds, so that at most its edges move. {3}",
     "l’area di distacco è trattenuta dall’attrito: il suo terreno, {1}, non è in alcun punto ripido come il pendio di "
     "{2} gradi che il suo attrito sostiene, così che si muovono al più i suoi bordi. {3}",
     "die Anrissfläche wird von der Reibung gehalten: ihr Gelände, {1}, ist nirgends so steil wie der Hang von {2} "
     "Grad, den ihre Reibung hält, sodass sich höchstens ihre Ränder bewegen. {3}",
     "la zone de départ est retenue par le frottement\u202F: son terrain, {1}, n’est nulle part aussi raide que la "
     "pente de {2} degrés que son frottement retient, de sorte que seuls ses bords bougent tout au plus. {3}",
     "el área de inicio queda retenida por la fricción: su terreno, {1}, no es en ningún punto tan empinado como la "
     "ladera de {2} grados que su fricción sostiene, de modo que se mueven a lo sumo sus bordes. {3}"},
    {"The elevations were converted from {1}, as the file says: if they are in metres already, set "
     "terrain.vertical-unit = metre. Otherwise check the elevations above against a map, and the friction",
     "Le quote sono state convertite da {1}, come dice il file: se sono già in metri, indicare terrain.vertical-unit = "
     "metre. Altrimenti confrontare le quote sopra con una carta, e controllare l’attrito",
     "Die Höhen wurden aus {1} umgerechnet, wie die Datei sagt: sind sie schon in Metern, terrain.vertical-unit = "
     "metre "
     "setzen. Sonst die Höhen oben mit einer Karte vergleichen und die Reibung prüfen",
     "Les altitudes ont été converties depuis {1}, comme l’indique le fichier\u202F: si elles sont déjà en mètres, "
     "indiquer terrain.vertical-unit = metre. Sinon comparer les altitudes ci-dessus à une carte, et vérifier le "
     "frottement",
     "Las cotas se convirtieron desde {1}, como dice el archivo: si ya están en metros, indique terrain.vertical-unit "
     "= "
     "metre. Si no, compare las cotas de arriba con un mapa y compruebe la fricción"},
    {"The elevations were converted from {1}: if they are in metres already, set terrain.vertical-unit = metre. "
     "Otherwise check the elevations above against a map, and the friction",
     "Le quote sono state convertite da {1}: se sono già in metri, indicare terrain.vertical-unit = metre. Altrimenti "
     "confrontare le quote sopra con una carta, e controllare l’attrito",
     "Die Höhen wurden aus {1} umgerechnet: sind sie schon in Metern, terrain.vertical-unit = metre setzen. Sonst die "
     "Höhen oben mit einer Karte vergleichen und die Reibung prüfen",
     "Les altitudes ont été converties depuis {1}\u202F: si elles sont déjà en mètres, indiquer terrain.vertical-unit "
     "= "
     "metre. Sinon comparer les altitudes ci-dessus à une carte, et vérifier le frottement",
     "Las cotas se convirtieron desde {1}: si ya están en metros, indique terrain.vertical-unit = metre. Si no, "
     "compare "
     "las cotas de arriba con un mapa y compruebe la fricción"},
    {"Elevations that are too low for their eastings look like this, as metres that were converted as if they were "
     "feet: check the elevations above against a map, and the friction",
     "Quote troppo basse rispetto alle coordinate est si presentano così, come metri convertiti quasi fossero piedi: "
     "confrontare le quote sopra con una carta, e controllare l’attrito",
     "So sehen Höhen aus, die für ihre Rechtswerte zu niedrig sind, wie Meter, die wie Fuß umgerechnet wurden: die "
     "Höhen oben mit einer Karte vergleichen und die Reibung prüfen",
     "Des altitudes trop basses pour leurs abscisses se présentent ainsi, comme des mètres convertis comme s’ils "
     "étaient "
     "des pieds\u202F: comparer les altitudes ci-dessus à une carte, et vérifier le frottement",
     "Cotas demasiado bajas para sus coordenadas este tienen este aspecto, como metros convertidos como si fueran "
     "pies: "
     "compare las cotas de arriba con un mapa y compruebe la fricción"},
    {"the path is steeper than those of landslides: {1}. {2}",
     "il percorso è più ripido di quelli delle frane: {1}. {2}",
     "der Fließweg ist steiler als die von Rutschungen: {1}. {2}",
     "le trajet est plus raide que ceux des glissements\u202F: {1}. {2}",
     "el trayecto es más empinado que los de los deslizamientos: {1}. {2}"},
});

}  // namespace

std::span<const WordRow> ground_warning_words() {
    return k_ground_warning_words;
}

}  // namespace frana
