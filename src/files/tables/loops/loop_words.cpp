// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_words.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/text.hpp"

namespace setae::tables {
namespace {

using Words = std::set<std::string, std::less<>>;

constexpr double sure = 0.95, phrase = 0.85, symbol = 0.7;

/// Words of a name in lower case without accents: letters and digits separated by other characters.
std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> words(1);
    for (const char c : folded(name)) {
        const bool part = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
        if (part) words.back() += c;
        else if (!words.back().empty()) words.emplace_back();
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

/// Other quantities with a unit of force, length or time next to those of a loop.
const Words& other_quantities() {
    static const Words words{"std", "stdev", "sd", "sem", "sigma", "error", "err", "uncertainty", "noise", "setpoint",
                             "target", "rate", "speed", "velocity", "slope", "max", "min", "temperature", "temp",
                             "humidity", "lateral", "friction", "shear", "tangential", "x", "y",
                             // German
                             "fehler", "abweichung", "standardabweichung", "streuung", "sollwert", "soll",
                             "geschwindigkeit", "temperatur", "reibung", "reibkraft", "querkraft", "steigung",
                             // French
                             "ecart", "erreur", "consigne", "vitesse", "laterale", "tangentielle", "frottement",
                             // Spanish, Italian, Portuguese, Dutch
                             "desviacion", "deviazione", "desvio", "afwijking", "consigna", "velocidad", "velocita",
                             "velocidade", "snelheid", "temperatura", "temperatuur", "friccion", "attrito", "atrito",
                             "wrijving"};
    return words;
}

/// Bodies whose radius is not that of the contact.
const Words& other_bodies() {
    static const Words words{"sphere", "lens",   "tip",      "probe", "bead",   "curvature", "kugel",
                             "linse",  "spitze", "lentille", "bille", "pointe", "esfera",    "lente",
                             "punta",  "sfera",  "ponta",    "bol",   "kogel"};
    return words;
}

template <class Container, class Value>
bool contains(const Container& container, const Value& value) {
    return std::find(container.begin(), container.end(), value) != container.end();
}

bool holds_any(const std::vector<std::string>& words, const Words& known) {
    return words.size() > 1 &&
           std::any_of(words.begin(), words.end(), [&](const auto& word) { return known.contains(word); });
}

/// The whole name, or a word in it, among those of `role`.
NamedRole by_words(const std::string& name, const std::vector<std::string>& words, const char* role,
                   const std::vector<std::string>& names, const std::vector<std::string>& known) {
    const auto plain = fmt::format("{}", fmt::join(words, " "));
    if (contains(names, plain)) return {sure, fmt::format("'{}' is a word for {}", name, role)};
    for (const auto& word : words)
        if (contains(known, word))
            return plain == word
                       ? NamedRole{sure, fmt::format("'{}' is a word for {}", name, role)}
                       : NamedRole{phrase, fmt::format("'{}' contains '{}', a word for {}", name, word, role)};
    return {};
}

}  // namespace

const std::vector<Vocabulary>& loop_vocabularies() {
    static const std::vector<Vocabulary> all{
        {"force",
         dimension::force,
         {"normal force", "normal load", "applied force", "applied load"},
         {"force", "load",
          // German, French, Spanish, Italian, Portuguese, Dutch
          "kraft", "last", "normalkraft", "prufkraft", "pruefkraft", "standardkraft", "druckkraft", "effort", "charge",
          "fuerza", "carga", "forza", "carico", "forca", "kracht", "belasting", "normaalkracht"},
         {"F", "P", "FN", "Fn", "F_N", "F_n", "Fz", "F_z"}},
        {"displacement",
         dimension::length,
         {"indentation depth", "approach"},
         {"displacement", "displ", "disp", "indentation", "penetration", "depth", "stage", "piezo", "position",
          "travel", "extension", "stroke", "crosshead", "zpiezo", "zsensor",
          // German, French, Spanish, Italian, Portuguese, Dutch
          "weg", "standardweg", "traversenweg", "verfahrweg", "stellweg", "verschiebung", "eindringtiefe", "tiefe",
          "deplacement", "enfoncement", "profondeur", "course", "traverse", "desplazamiento", "posicion", "profundidad",
          "penetracion", "indentacion", "carrera", "spostamento", "posizione", "profondita", "penetrazione",
          "indentazione", "corsa", "deslocamento", "posicao", "profundidade", "penetracao", "indentacao", "curso",
          "verplaatsing", "positie", "indringing", "indringdiepte", "diepte", "slag"},
         {"d", "z", "Z", "h", "δ", "delta", "Δ"}},
        {"contact_radius",
         dimension::length,
         {"contact radius", "radius of contact", "contact_radius"},
         {"radius", "radii", "kontaktradius", "rayon", "radio", "raggio", "raio", "straal", "contactstraal"},
         {"a", "r_c", "rc", "a_c"}},
        {"time",
         dimension::time,
         {"elapsed time"},
         {"time", "clock", "timestamp", "zeit", "messzeit", "prufzeit", "pruefzeit", "temps", "tiempo", "tempo",
          "tijd"},
         {"t"}}};
    return all;
}

NamedRole named_role(const std::string& name, const Vocabulary& role) {
    const auto words = words_of(name);
    const bool of_radius = role.role == std::string_view("contact_radius");
    if (holds_any(words, other_quantities()) || (of_radius && holds_any(words, other_bodies()))) return {};
    if (auto named = by_words(name, words, role.role, role.names, role.words); named.confidence > 0.0) return named;
    if (contains(role.symbols, name)) return {symbol, fmt::format("'{}' is a symbol of {}", name, role.role)};
    return {};
}

NamedRole named_gap(const std::string& name) {
    static const std::vector<std::string> gaps{"gap",      "separation", "clearance",   "spalt",     "abstand", "ecart",
                                               "entrefer", "separacion", "separazione", "separacao", "spleet"};
    const auto words = words_of(name);
    // the French écart is a gap if alone, and a deviation with other words
    if (holds_any(words, other_quantities())) return {};
    return by_words(name, words, "the gap between the bodies", {}, gaps);
}

bool names_contact_area(const std::string& name) {
    static const std::vector<std::string> areas{"area",    "aire",          "surface",        "flache",
                                                "flaeche", "kontaktflache", "kontaktflaeche", "superficie"};
    static const std::vector<std::string> contacts{"contact", "kontakt", "contacto", "contatto", "contato"};
    const auto words = words_of(name);
    const auto any = [&](const auto& known) {
        return std::any_of(words.begin(), words.end(), [&](const auto& word) { return contains(known, word); });
    };
    return name == "A" || name == "A_c" || (any(areas) && (words.size() == 1 || any(contacts)) && !is_qualified(name));
}

bool is_qualified(const std::string& name) { return holds_any(words_of(name), other_quantities()); }

}  // namespace setae::tables
