#include "hodt/io/column_names.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "hodt/io/field_kind.h"
#include "hodt/io/text_encoding.h"

namespace hodt {

namespace {

struct RoleWords {
  ColumnRole role;
  std::string_view words;  ///< folded, blanks between
};

/// In the order of languages: English, German, French, Spanish, Italian, Portuguese, Dutch, the
/// Scandinavian ones and Finnish, then Polish, Czech, Hungarian and Turkish.
constexpr RoleWords kWords[] = {
    {ColumnRole::x, "x"},
    {ColumnRole::y, "y"},
    {ColumnRole::east,
     "e east easting eastings ostwert rechts rechtswert rw ost est este leste oost oest oesting "
     "itae itakoordinaatti wschod vychod kelet"},
    {ColumnRole::north,
     "n north northing northings nordwert hoch hochwert hw nord norte noord nording pohjoinen "
     "polnoc sever eszak"},
    {ColumnRole::longitude,
     "lon long lng longitude laenge laengengrad geolaenge longitud longitudine lengte "
     "lengtegraad laengdgrad laengd laengdegrad lengdegrad dlugosc delka boylam"},
    {ColumnRole::latitude,
     "lat latitude breite breitengrad geobreite latitud latitudine breedte breedtegraad breddgrad "
     "bredd breddegrad szerokosc sirka enlem"},
    {ColumnRole::height,
     "z h elevation elev ele height hgt ht altitude alt hoehe hoehen hoehenwert hoehenkote "
     "gelaendehoehe kote kot hauteur cote elevacion altura cota altitud quota altezza altitudine "
     "elevazione elevacao hoogte hoejd hojd hoejde hoeyde korkeus wysokosc rzedna vyska magassag "
     "yukseklik"},
    {ColumnRole::other,
     "id ids fid gid oid uid objectid ogcfid rowid row p point points pt pts pnt pkt pid nr no num "
     "number "
     "nummer "
     "numero nro index idx punkt punkte punktnummer punktnr pktnr ptnr pointid pointno ptid "
     "station "
     "name nom nombre nome naam navn namn label code kod codigo codice d desc descr description "
     "beschreibung bezeichnung bemerkung remark remarks comment comments kommentar layer type typ "
     "class classification intensity red green blue alpha nx ny nz date datum time "
     "timestamp zeit datetime wkt geom geometry quality"},
};

/// Words that say nothing about which coordinate it is: units, datums and projections, and words
/// for coordinates as such.
constexpr std::string_view kNoise =
    " m mm cm km meter meters metre metres ft feet foot usft ftus survey deg degree degrees dd "
    "grad dec decimal abs absolute "
    "msl amsl asl wgs84 wgs utm epsg lv95 lv03 gk nhn nn nhn2016 dhhn dhhn2016 navd88 navd ngvd29 "
    "egm96 egm2008 egm ln02 lhn95 nad83 nad27 nad etrs89 etrs gda94 gda2020 mga94 mga2020 mga ahd "
    "osgb osgb36 bng itm nztm l93 lambert lambert93 lambert72 rgf93 ign69 ngf rd nap sweref99 "
    "sweref tm rh2000 rt90 jtsk bpv dvr90 nn2000 ch1903 mgi egsa spcs ellipsoidal ellipsoid "
    "orthometric ellipsoidisch orthometrisch "
    "coord coords coordinate coordinates koord koordinate koordinaten coordonnee coordonnees "
    "coordenada coordinata coordinaat koordinat koordinaatti wert value val axis achse point punkt "
    "gps gnss rtk pos position map grid local geo geogr geographic geografische in of the "
    "ue ueber uenn uem muem slm msnm snm s l above sea level ";

/// Words for parts of an angle: degrees alone are not all of it.
constexpr std::string_view kAngleParts =
    " min mins minute minutes minuten sec secs second seconds sekunden dms dir hemisphere ref d m "
    "s ";

bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != words.npos; at = words.find(word, at + 1)) {
    const bool starts = at == 0 || words[at - 1] == ' ';
    const std::size_t end = at + word.size();
    if (starts && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

ColumnRole role_of_word(std::string_view word) {
  for (const auto& [role, words] : kWords) {
    if (has_word(words, word)) return role;
  }
  return ColumnRole::unknown;
}

/// ASCII spellings of the letters U+00C0 to U+00FF.
constexpr std::array<std::string_view, 64> kLatin = {
    "a", "a", "a", "a", "ae", "a", "ae", "c", "e",  "e", "e", "e", "i",  "i", "i",  "i",
    "d", "n", "o", "o", "o",  "o", "oe", " ", "oe", "u", "u", "u", "ue", "y", "th", "ss",
    "a", "a", "a", "a", "ae", "a", "ae", "c", "e",  "e", "e", "e", "i",  "i", "i",  "i",
    "d", "n", "o", "o", "o",  "o", "oe", " ", "oe", "u", "u", "u", "ue", "y", "th", "y"};

struct Letter {
  char32_t point;
  char spelling;
};
constexpr Letter kLetters[] = {
    {U'ą', 'a'}, {U'ć', 'c'}, {U'č', 'c'}, {U'ď', 'd'}, {U'ę', 'e'}, {U'ě', 'e'}, {U'ğ', 'g'},
    {U'ı', 'i'}, {U'İ', 'i'}, {U'ł', 'l'}, {U'Ł', 'l'}, {U'ń', 'n'}, {U'ő', 'o'}, {U'ř', 'r'},
    {U'ś', 's'}, {U'Ś', 's'}, {U'š', 's'}, {U'Š', 's'}, {U'ş', 's'}, {U'Ş', 's'}, {U'ť', 't'},
    {U'ů', 'u'}, {U'ű', 'u'}, {U'ź', 'z'}, {U'ż', 'z'}, {U'ž', 'z'}};

void append_folded(std::string& folded, char32_t point) {
  if (point < 0x80) {
    const char c = static_cast<char>(point);
    const bool letter = ('a' <= c && c <= 'z') || ('0' <= c && c <= '9');
    folded.push_back(letter ? c : ' ');
  } else if (0xC0 <= point && point < 0x100) {
    folded += kLatin[point - 0xC0];
  } else {
    const auto letter = std::find_if(std::begin(kLetters), std::end(kLetters),
                                     [&](const Letter& l) { return l.point == point; });
    // Signs, like that for degrees, separate; letters of other scripts stay a word nobody knows.
    folded += letter != std::end(kLetters) ? std::string(1, letter->spelling)
                                           : std::string(point < 0xC0 ? " " : "?");
  }
}

/// The words of a name, in lower case ASCII: "decimalLatitude" and "Höhe [m]" are two each.
std::vector<std::string> words_of(std::string_view name) {
  std::string folded;
  bool after_small = false;
  while (!name.empty()) {
    const char32_t point = take_code_point(name);
    const bool capital = U'A' <= point && point <= U'Z';
    if (capital && after_small) folded.push_back(' ');
    after_small = U'a' <= point && point <= U'z';
    append_folded(folded, capital ? point - U'A' + U'a' : point);
  }
  std::vector<std::string> words;
  for (const std::string& word : split_row(folded, kWhiteSpace)) words.push_back(word);
  return words;
}

bool is_noise(std::string_view word) {
  return ('0' <= word[0] && word[0] <= '9') || has_word(kNoise, word);
}

/// "xcoord" and "pointx" are an axis and a word that says nothing, written together.
ColumnRole role_of_compound(std::string_view word) {
  if (word.size() < 3) return ColumnRole::unknown;
  for (const std::string_view axis : {"x", "y", "z"}) {
    if ((word.starts_with(axis) && has_word(kNoise, word.substr(1))) ||
        (word.ends_with(axis) && has_word(kNoise, word.substr(0, word.size() - 1))))
      return role_of_word(axis);
  }
  return ColumnRole::unknown;
}

/// Degrees without their minutes, or an angle without its hemisphere, would be misread: their
/// columns make the latitude ambiguous.
ColumnRole role_of_angle_part(const std::vector<std::string>& words) {
  ColumnRole role = ColumnRole::unknown;
  bool part = false;
  for (const std::string& word : words) {
    part = part || has_word(kAngleParts, word);
    const ColumnRole found = role_of_word(word);
    if (found == ColumnRole::latitude || found == ColumnRole::longitude) role = found;
  }
  if (part) return role;
  if (words == std::vector<std::string>{"n", "s"}) return ColumnRole::latitude;
  if (words == std::vector<std::string>{"e", "w"}) return ColumnRole::longitude;
  return ColumnRole::unknown;
}

/// Words for what is told about a coordinate.
constexpr std::string_view kAboutValues =
    " std stddev stdev sd sigma error errors err fehler accuracy acc genauigkeit precision rms "
    "rmse "
    "var variance uncertainty velocity vel speed diff delta residual ";

/// The coordinate that a name begins with although it is not understood as a whole, as in
/// "easting_utm32n".
ColumnRole role_of_beginning(std::string_view name) {
  if (role_of(name) != ColumnRole::unknown) return ColumnRole::unknown;
  const std::vector<std::string> words = words_of(name);
  const bool is_about = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return has_word(kAboutValues, word);
  });
  return words.empty() || is_about ? ColumnRole::unknown : role_of_word(words[0]);
}

/// The columns of one role.
using Columns = std::vector<std::size_t>;

Columns columns_of(const std::vector<ColumnRole>& roles, std::initializer_list<ColumnRole> wanted) {
  Columns columns;
  for (std::size_t i = 0; i < roles.size(); ++i)
    if (std::find(wanted.begin(), wanted.end(), roles[i]) != wanted.end()) columns.push_back(i);
  return columns;
}

Columns columns_called(const std::vector<std::string>& names, std::string_view plain) {
  Columns columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = lower_case(names[i]);
    if (trimmed(std::string_view(name).substr(0, name.find_first_of("([", 1))) == plain)
      columns.push_back(i);
  }
  return columns;
}

/// Finds the coordinates one after the other, the surest names first.
class ColumnSearch {
 public:
  explicit ColumnSearch(const std::vector<std::string>& names) : names_(names) {
    for (const std::string& name : names) {
      roles_.push_back(role_of(name));
      beginnings_.push_back(role_of_beginning(name));
    }
  }

  NamedColumns find() && {
    find_plane();
    find_height();
    return std::move(found_);
  }

 private:
  using enum ColumnRole;

  void find_plane() {
    const Columns exact_x = columns_called(names_, "x"), exact_y = columns_called(names_, "y");
    if (!exact_x.empty() && !exact_y.empty()) return take_plane(exact_x, exact_y);
    const Columns xs = columns_of(roles_, {x}), ys = columns_of(roles_, {y});
    const Columns easts = columns_of(roles_, {east}), norths = columns_of(roles_, {north});
    const bool letters = !xs.empty() && !ys.empty();
    const bool compass = !easts.empty() && !norths.empty();
    if (letters && compass)
      return take_plane(columns_of(roles_, {x, east}), columns_of(roles_, {y, north}));
    if (letters) return take_plane(with_rivals(xs, ys, {x, east}, {y, north}));
    if (compass) return take_plane(with_rivals(easts, norths, {x, east}, {y, north}));
    const Columns lons = columns_of(roles_, {longitude}), lats = columns_of(roles_, {latitude});
    if (!lons.empty() && !lats.empty())
      return take_plane(with_rivals(lons, lats, {longitude}, {latitude}));
    const Columns some = columns_of(roles_, {x, y, east, north, longitude, latitude, height});
    if (!some.empty())
      found_.plane_problem = fmt::format("the names {} do not name both x and y", listed(names_));
  }

  void find_height() {
    const Columns exact = columns_called(names_, "z");
    take("z", exact.empty() ? columns_of(roles_, {height}) : exact, found_.z,
         found_.height_problem);
  }

  using Plane = std::pair<Columns, Columns>;
  using Roles = std::initializer_list<ColumnRole>;

  /// The columns, and such that could be of another system of coordinates, if there are of both
  /// axes.
  Plane with_rivals(Columns xs, Columns ys, Roles x_roles, Roles y_roles) const {
    const Columns more_xs = columns_of(beginnings_, x_roles);
    const Columns more_ys = columns_of(beginnings_, y_roles);
    if (more_xs.empty() || more_ys.empty()) return {std::move(xs), std::move(ys)};
    xs.insert(xs.end(), more_xs.begin(), more_xs.end());
    ys.insert(ys.end(), more_ys.begin(), more_ys.end());
    return {std::move(xs), std::move(ys)};
  }

  void take_plane(const Plane& plane) { take_plane(plane.first, plane.second); }
  void take_plane(const Columns& xs, const Columns& ys) {
    take("x", xs, found_.x, found_.plane_problem);
    take("y", ys, found_.y, found_.plane_problem);
    found_.several_planes = !found_.plane();
  }

  void take(std::string_view axis, const Columns& columns, std::optional<std::size_t>& column,
            std::string& problem) {
    if (columns.size() == 1) column = columns[0];
    if (columns.size() < 2 || !problem.empty()) return;
    std::vector<std::string> candidates;
    for (const std::size_t i : columns) candidates.push_back(names_[i]);
    problem = fmt::format("{} could be any of the columns {}", axis, listed(candidates));
  }

  const std::vector<std::string>& names_;
  std::vector<ColumnRole> roles_, beginnings_;
  NamedColumns found_;
};

}  // namespace

ColumnRole role_of(std::string_view name) {
  std::vector<std::string> words = words_of(name);
  if (const ColumnRole role = role_of_angle_part(words); role != ColumnRole::unknown) return role;
  std::vector<std::string> telling;
  std::copy_if(words.begin(), words.end(), std::back_inserter(telling),
               [](const std::string& word) { return !is_noise(word); });
  // "Point" alone says that the column holds names of points.
  if (telling.empty()) {
    const bool known = std::any_of(words.begin(), words.end(), [](const std::string& word) {
      return role_of_word(word) == ColumnRole::other;
    });
    return known ? ColumnRole::other : ColumnRole::unknown;
  }
  if (telling.size() > 1) {
    const bool known = std::all_of(telling.begin(), telling.end(), [](const std::string& word) {
      return role_of_word(word) == ColumnRole::other;
    });
    return known ? ColumnRole::other : ColumnRole::unknown;
  }
  const ColumnRole role = role_of_word(telling[0]);
  return role != ColumnRole::unknown ? role : role_of_compound(telling[0]);
}

NamedColumns find_columns(const std::vector<std::string>& names) {
  return ColumnSearch(names).find();
}

bool only_number_columns(const std::vector<std::string>& names) {
  if (names.empty() || names[0].empty()) return false;
  const char first = names[0].back();
  const std::string stem = names[0].substr(0, names[0].size() - 1);
  const bool is_number = first == '0' || first == '1';
  if (!is_number && !(stem.empty() && (first == 'a' || first == 'A'))) return false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string next = is_number ? std::to_string(std::size_t(first - '0') + i)
                                       : std::string(1, static_cast<char>(first + i));
    if (names[i] != stem + next) return false;
  }
  return true;
}

std::optional<std::size_t> column_called(const std::string& name,
                                         const std::vector<std::string>& names) {
  const auto position = [&](const auto& same) -> std::optional<std::size_t> {
    const auto found = std::find_if(names.begin(), names.end(), same);
    if (found == names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
  };
  // The names can be in Latin-1, and whoever asks has seen them in UTF-8.
  if (const auto exact = position([&](const auto& other) { return readable(other) == name; }))
    return exact;
  const std::string lower = lower_case(name);
  return position([&](const auto& other) { return lower_case(readable(other)) == lower; });
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    list += (i > 0 ? ", " : "") + in_quotes(names[i]);
  return list + (names.size() > most ? ", ..." : "");
}

bool is_unit(std::string_view field) {
  constexpr std::string_view units =
      " m mm cm km meter meters metre metres ft feet foot usft deg degree degrees dd rad gon grad "
      "none text string double float real int integer ";
  field = trimmed(field);
  const bool bracketed = field.size() > 2 && (field.front() == '[' || field.front() == '(') &&
                         (field.back() == ']' || field.back() == ')');
  if (bracketed) return true;
  return field == "°" || (!field.empty() && has_word(units, lower_case(field)));
}

}  // namespace hodt
