#include "app/cli/method_pages.h"

#include "app/cli/param_text.h"
#include "core/io/image_file.h"
#include "core/session/export/output_guard.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace texloom::cli {

namespace {

/// Text in a cell of a table.
std::string cell(const std::string& text) {
    std::string safe;
    for (const char letter : text) {
        if (letter == '|')
            safe += '\\';
        safe += letter;
    }
    return safe;
}

std::string titleOf(const Param& param) {
    return param.symbol().empty() ? param.title() : fmt::format("{} ({})", param.title(), param.symbol());
}

std::string helpOf(const Param& param) {
    if (!param.condition())
        return param.help();
    return fmt::format("{} Matters only with `{}={}`.", param.help(), param.condition()->name,
                       toText(param.condition()->value));
}

/// Whether many methods have this port, so that a line of its own says what it is.
bool isUsual(const Port& port) {
    return port.id == kExemplarPort || port.id == kMaskPort || port.id == kInitialPort ||
           port.id == kCompanionPort;
}

/// What a method can do beside the least, one line each.
std::vector<std::string> abilities(const MethodInfo& info) {
    const std::pair<bool, const char*> all[] = {
        {!info.takesExemplars(), "It learns from no exemplar."},
        {info.copiesPixels(),
         "Every pixel is copied from the exemplar, and the position map says from where."},
        {info.canWrap(), "The output tiles on either axis (`--wrap x`, `y` or `xy`)."},
        {info.makesParts(),
         "Any part of a larger output can be made alone (`--region`), so that size has no limit."},
        {info.learnsFromSeveral(),
         info.heedsWeights() ? "It learns from several exemplars, each as much as it weighs (`--weight`)."
                             : "It learns from several exemplars."},
        {info.heedsMasks(), "What a mask hides in an exemplar is left out (`--mask`)."},
        {info.startsFromImage(),
         "It can start from an image (`--init`) or follow another method (`--then`)."},
        {info.keepsCheckpoints, "A run that was killed goes on from its last checkpoint (`--resume`)."},
    };
    std::vector<std::string> lines;
    for (const auto& [can, line] : all)
        if (can)
            lines.emplace_back(line);
    for (const Port& port : info.takes)
        if (!isUsual(port))
            lines.push_back(fmt::format("`--input {}=FILE` gives it {}. {}", port.id,
                                        kindText(port.kind).text(), port.help));
    for (const Port& port : info.gives)
        if (port.id != kImagePort && port.id != kMapPort)
            lines.push_back(fmt::format("`--save {}=FILE` writes {}. {}", port.id, kindText(port.kind).text(),
                                        port.help));
    return lines;
}

std::string parameterTable(const Method& method) {
    if (method.params().empty())
        return "It has none.\n";
    std::string table = "| `--set` | Parameter | Range | Default | |\n|---|---|---|---|---|\n";
    for (const Param& param : method.params())
        table += fmt::format("| `{}` | {} | {} | {} | {} |\n", param.name(), cell(titleOf(param)),
                             cell(param.limits().text()), cell(defaultText(param)), cell(helpOf(param)));
    return table;
}

std::string listPage() {
    std::string page =
        "<!-- Written by `texloom-cli methods --markdown docs/methods` from the declarations. -->\n"
        "# Methods\n\n| Method | Kind | |\n|---|---|---|\n";
    for (const Method* method : methodsByCategory())
        page += fmt::format("| [{}]({}.md) | {} | {} |\n", method->info().title, method->id(),
                            categoryTitle(method->info().category), cell(method->info().summary));
    return page;
}

} // namespace

std::string methodPage(const Method& method) {
    const MethodInfo& info = method.info();
    std::string page = fmt::format(
        "<!-- Written by `texloom-cli methods --markdown docs/methods` from the declaration. -->\n"
        "# {}\n\n{}\n\nAfter {}.\n\n![Made by {}](picture/{}.jpg)\n\n"
        "    texloom-cli synth {}{} -o OUTPUT\n\n",
        info.title, info.summary, info.citation, info.title, method.id(), method.id(),
        info.takesExemplars() ? " EXEMPLAR" : "");
    const std::vector<std::string> lines = abilities(info);
    for (const std::string& line : lines)
        page += fmt::format("- {}\n", line);
    page += fmt::format("{}## Parameters\n\n{}", lines.empty() ? "" : "\n", parameterTable(method));
    return page;
}

void writeMethodPages(const std::filesystem::path& folder, bool overwrite) {
    OutputGuard guard;
    for (const Method& method : methods())
        guard.writes(folder / (method.id() + ".md"), TR("page"));
    guard.writes(folder / "README.md", TR("page"));
    guard.check(overwrite);
    std::filesystem::create_directories(folder);
    for (const Method& method : methods())
        writeText(folder / (method.id() + ".md"), methodPage(method));
    writeText(folder / "README.md", listPage());
}

} // namespace texloom::cli
