#pragma once

class QAction;
class QMainWindow;

namespace texloom::ui {

/// Everything the main window can do, once each: menus, toolbar and buttons all show these.
struct Actions {
    /// Makes them as children of `window`, with texts, keys, icons and object names.
    explicit Actions(QMainWindow* window);

    QAction* open;
    QAction* paste;
    QAction* exportResult;
    QAction* exportAgain;
    QAction* quit;
    QAction* copyResult;
    QAction* setMask;
    QAction* clearMask;
    QAction* removeExemplar;
    QAction* editExemplar;
    QAction* addCompanions;
    QAction* run;
    QAction* addToQueue;
    QAction* quick;
    QAction* stop;
    QAction* cancelRun;
    QAction* newSeedRun;
    QAction* resetParameters;
    QAction* extend;
    QAction* fit;
    QAction* actualSize;
    QAction* zoomIn;
    QAction* zoomOut;
    QAction* repeat;
    QAction* seams;
    QAction* navigator;
    QAction* scope;
    QAction* resultTab;
    QAction* synthesisTab;
    QAction* positionTab;
    QAction* copiesTab;
    QAction* lattice;
    QAction* blend;
    QAction* variance;
    QAction* stress;
    QAction* resetLayout;
    QAction* stackPanels;
    QAction* fullScreen;
    QAction* shortcuts;
    QAction* about;
};

} // namespace texloom::ui
