// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_term_words = std::to_array<WordRow>({
    {"hydrostatic pressure", "pressione idrostatica", "hydrostatischer Druck", "pression hydrostatique",
     "presión hidrostática"},
    {"bed slope", "pendenza del fondo", "Sohlneigung", "pente du lit", "pendiente del lecho"},
    {"slope correction: normal", "correzione di pendenza: normal", "Neigungskorrektur: normal",
     "correction de pente\u202F: normal", "corrección de pendiente: normal"},
    {"slope correction: surface", "correzione di pendenza: surface", "Neigungskorrektur: surface",
     "correction de pente\u202F: surface", "corrección de pendiente: surface"},
    {"curvature of the bed", "curvatura del fondo", "Krümmung der Sohle", "courbure du lit", "curvatura del lecho"},
    {"flight over edges", "volo oltre i cigli", "Flug über Kanten", "vol au-dessus des rebords",
     "vuelo sobre los bordes"},
    {"surface pressure", "pressione sulla superficie", "Oberflächendruck", "pression en surface",
     "presión en la superficie"},
    {"pore pressure that dissipates", "pressione interstiziale che si dissipa", "abklingender Porendruck",
     "pression interstitielle qui se dissipe", "presión de poros que se disipa"},
    {"constant pore pressure", "pressione interstiziale costante", "konstanter Porendruck",
     "pression interstitielle constante", "presión de poros constante"},
    {"{1} by zones", "{1} secondo zone", "{1} nach Zonen", "{1} par zones", "{1} por zonas"},
    {"exact", "esatta", "exakt", "exacte", "exacta"},
    {"quadratic", "quadratica", "quadratisch", "quadratique", "cuadrática"},
    {"bilinear shape functions", "funzioni di forma bilineari", "bilineare Formfunktionen",
     "fonctions de forme bilinéaires", "funciones de forma bilineales"},
    {"quadratic B-splines", "B-spline quadratiche", "quadratische B-Splines", "B-splines quadratiques",
     "B-splines cuadráticas"},
    {"reference level per node", "livello di riferimento per nodo", "Bezugsniveau je Knoten",
     "niveau de référence par nœud", "nivel de referencia por nodo"},
    {"area relaxation", "rilassamento delle aree", "Relaxation der Flächen", "relaxation des surfaces",
     "relajación de áreas"},
    {"compressive artificial viscosity", "viscosità artificiale in compressione", "künstliche Viskosität bei Stauchung",
     "viscosité artificielle en compression", "viscosidad artificial en compresión"},
    {"splitting and merging", "suddivisione e fusione", "Teilen und Vereinen", "division et fusion",
     "división y fusión"},
    {"elasticity and Drucker-Prager plasticity of solids", "elasticità e plasticità di Drucker-Prager dei solidi",
     "Elastizität und Drucker-Prager-Plastizität der Feststoffe",
     "élasticité et plasticité de Drucker-Prager des solides",
     "elasticidad y plasticidad de Drucker-Prager de los sólidos"},
    {"lateral earth pressure", "spinta laterale delle terre", "seitlicher Erddruck", "poussée latérale des terres",
     "empuje lateral de tierras"},
    {"hydrostatic beyond the strength", "idrostatica oltre la resistenza", "hydrostatisch über die Festigkeit hinaus",
     "hydrostatique au-delà de la résistance", "hidrostático más allá de la resistencia"},
    {"active", "attiva", "aktiv", "active", "activo"},
    {"active and passive", "attiva e passiva", "aktiv und passiv", "active et passive", "activo y pasivo"},
    {"cohesion lost with strain", "coesione persa con la deformazione", "mit der Dehnung verlorene Kohäsion",
     "cohésion perdue avec la déformation", "cohesión perdida con la deformación"},
    {"release of confined fluid", "rilascio del fluido confinato", "Freiwerden gebundenen Fluids",
     "libération du fluide confiné", "liberación del fluido confinado"},
    {"buoyancy", "spinta di galleggiamento", "Auftrieb", "poussée d’Archimède", "empuje de Arquímedes"},
    {"drag", "resistenza di trascinamento", "Strömungswiderstand", "traînée", "arrastre"},
    {"virtual mass", "massa virtuale", "virtuelle Masse", "masse virtuelle", "masa virtual"},
    {"viscous shear at the bed", "taglio viscoso al fondo", "viskose Scherung an der Sohle",
     "cisaillement visqueux au lit", "corte viscoso en el lecho"},
    {"finite volumes", "volumi finiti", "finite Volumen", "volumes finis", "volúmenes finitos"},
    {"MUSCL with hydrostatic reconstruction", "MUSCL con ricostruzione idrostatica",
     "MUSCL mit hydrostatischer Rekonstruktion", "MUSCL avec reconstruction hydrostatique",
     "MUSCL con reconstrucción hidrostática"},
});

}  // namespace

std::span<const WordRow> term_words() {
    return k_term_words;
}

}  // namespace frana
