#include "ui/window/actions.h"

#include "ui/common/icons.h"
#include "ui/common/shortcuts.h"
#include "ui/viewers/viewer_keys.h"

#include <QAction>
#include <QCoreApplication>
#include <QMainWindow>

namespace texloom::ui {

namespace {

struct Maker {
    QMainWindow* window;

    QAction* operator()(const char* name, const QString& text, const QList<QKeySequence>& keys = {},
                        const QString& help = {}, const char* iconName = nullptr) const {
        auto* action = new QAction(text, window);
        action->setObjectName(QLatin1String(name));
        action->setShortcuts(keys);
        QString plain = text;
        plain.remove(QLatin1Char('&')).remove(QStringLiteral("…"));
        setHelp(action, help.isEmpty() ? plain : help);
        if (iconName != nullptr)
            action->setIcon(icon(QLatin1String(iconName)));
        window->addAction(action);
        return action;
    }
};

/// Viewers do at a key what the action does, with the keys that it has at the moment.
void shareKeys(QAction* action, ViewerCommand command) {
    const auto share = [action, command] { setViewerKeys(command, action->shortcuts()); };
    QObject::connect(action, &QAction::changed, action, share);
    share();
}

QString tr(const char* text) {
    return QCoreApplication::translate("texloom::ui::Actions", text);
}

} // namespace

Actions::Actions(QMainWindow* window) {
    const Maker make{window};
    open = make("open", tr("&Open…"), {QKeySequence::Open}, tr("Open exemplars or a recipe"), "open");
    paste = make("paste", tr("&Paste"), {QKeySequence::Paste}, tr("Paste a picture or a file as an exemplar"),
                 "paste");
    exportResult = make("export", tr("&Export…"), {Qt::CTRL | Qt::Key_E},
                        tr("Write the result and its maps to files"), "export");
    exportAgain =
        make("exportAgain", tr("Export a&gain"), {Qt::CTRL | Qt::SHIFT | Qt::Key_E},
             tr("Write the result to the folder and in the way of the last export, without asking"));
    quit = make("quit", tr("&Quit"), {Qt::CTRL | Qt::Key_Q});
    copyResult =
        make("copyResult", tr("&Copy result"), {QKeySequence::Copy}, tr("Copy the result as a picture"));
    setMask = make("setExemplarMask", tr("Set &mask…"));
    clearMask = make("clearExemplarMask", tr("&Clear mask"));
    removeExemplar = make("removeExemplar", tr("&Remove"), {Qt::CTRL | Qt::Key_Delete},
                          tr("Take the exemplar off the list; its file stays"), "close");
    editExemplar = make("editExemplar", tr("E&dit…"), {Qt::CTRL | Qt::Key_D},
                        tr("Crop, turn, rectify, even out the light, hide parts"));
    editExemplar->setCheckable(true);
    addCompanions = make("addCompanions", tr("Add companion &maps…"));
    run = make("run", tr("&Run"), {Qt::CTRL | Qt::Key_Return, Qt::CTRL | Qt::Key_Enter},
               tr("Make the result; if a run is under way, right after it, but a quick preview gives way"),
               "run");
    addToQueue = make("addToQueue", tr("&Add to queue"),
                      {Qt::CTRL | Qt::ALT | Qt::Key_Return, Qt::CTRL | Qt::ALT | Qt::Key_Enter},
                      tr("Make the result with these settings after all runs that wait"), "queue");
    quick = make("quick", tr("&Quick"),
                 {Qt::CTRL | Qt::SHIFT | Qt::Key_Return, Qt::CTRL | Qt::SHIFT | Qt::Key_Enter},
                 tr("Make a small preview with the same settings"), "quick");
    stop =
        make("stop", tr("&Stop and keep"), {Qt::Key_Escape},
             tr("End the run under way and keep what is there as a result; those that wait go on"), "stop");
    stop->setIconText(tr("Stop"));
    cancelRun = make("cancelRun", tr("&Cancel run"), {Qt::SHIFT | Qt::Key_Escape},
                     tr("End the run under way and keep nothing of it; those that wait go on"), "close");
    newSeedRun = make("newSeedRun", tr("&New seed and run"), {Qt::CTRL | Qt::Key_R}, {}, "dice");
    resetParameters = make("resetParameters", tr("Reset all &parameters"), {}, {}, "reset");
    extend =
        make("extendCanvas", tr("E&xtend a picture…"), {},
             tr("Make more of a picture beyond its edges, with a method that completes pictures"), "extend");
    fit = make("fit", tr("&Fit"), {Qt::Key_F}, tr("Fit the picture in the view"), "fit");
    actualSize = make("actualSize", tr("&100 %"), {Qt::Key_1},
                      tr("One screen pixel for each of the picture's"), "actual-size");
    zoomIn = make("zoomIn", tr("Zoom &in"), {Qt::Key_Plus, Qt::Key_Equal}, {}, "zoom-in");
    zoomOut = make("zoomOut", tr("Zoom &out"), {Qt::Key_Minus}, {}, "zoom-out");
    repeat = make("repeat", tr("&Repeat"), {Qt::Key_W}, tr("Show the picture repeated on all sides"), "wrap");
    repeat->setCheckable(true);
    seams = make("seams", tr("&Half offset"), {Qt::Key_H},
                 tr("Show the picture repeated, with the corner where its tiles meet in the middle"));
    navigator = make("navigator", tr("&Navigator"), {Qt::Key_N},
                     tr("Show the whole picture small where a part of it is shown, or hide it"));
    scope = make("scope", tr("H&istogram, waveform"), {Qt::Key_I},
                 tr("Show the histogram of the picture, then its waveform, then neither"));
    resultTab = make("showResult", tr("R&esult"), {Qt::CTRL | Qt::Key_1});
    synthesisTab = make("showSynthesisMap", tr("&Synthesis map"), {Qt::CTRL | Qt::Key_2});
    positionTab = make("showPositionMap", tr("&Position map"), {Qt::CTRL | Qt::Key_3});
    copiesTab = make("showCopies", tr("&Copied pieces"), {Qt::CTRL | Qt::Key_4});
    lattice = make("lattice", tr("&Lattice"), {Qt::CTRL | Qt::Key_L},
                   tr("Find or set the vectors by which the exemplar repeats itself"), "lattice");
    blend =
        make("blend", tr("&Blend two images…"), {Qt::CTRL | Qt::Key_B}, tr("Join two images along a curve"));
    variance = make("variance", tr("Patch &variance…"), {},
                    tr("How much patches vary that are alike, by their size and number"));
    stress = make("stress", tr("&Stress test…"), {},
                  tr("Make a texture of the texture of the texture, to see what the method loses"));
    resetLayout = make("resetLayout", tr("Reset &layout"));
    stackPanels = make("stackPanels", tr("Stac&k panels"), {},
                       tr("Put all panels on one another at the right, as on small screens"));
    stackPanels->setCheckable(true);
    fullScreen = make("fullScreen", tr("F&ull screen"), {Qt::Key_F11});
    fullScreen->setCheckable(true);
    shortcuts = make("shortcuts", tr("&Keyboard shortcuts"), {Qt::Key_Question}, {}, "help");
    about = make("about", tr("&About Texloom"));
    shareKeys(fit, ViewerCommand::Fit);
    shareKeys(actualSize, ViewerCommand::ActualSize);
    shareKeys(zoomIn, ViewerCommand::ZoomIn);
    shareKeys(zoomOut, ViewerCommand::ZoomOut);
    shareKeys(repeat, ViewerCommand::Repeat);
    shareKeys(seams, ViewerCommand::Seams);
    shareKeys(navigator, ViewerCommand::Navigator);
    shareKeys(scope, ViewerCommand::Scope);
    about->setMenuRole(QAction::AboutRole);
    quit->setMenuRole(QAction::QuitRole);
}

} // namespace texloom::ui
