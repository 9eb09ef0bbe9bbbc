#include "core/session/run/exemplar_use.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/value_editor.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/param_row.h"
#include "ui/inspector/seed_edit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include <limits>

using namespace texloom;
using namespace texloom::ui;

namespace {

/// A value of the parameter's that is not its default.
Value otherValue(const Param& param) {
    const Value usual = param.defaultFor(0);
    switch (param.type()) {
    case Param::Type::Toggle:
        return !std::get<bool>(usual);
    case Param::Type::Integer:
        return std::get<int>(usual) == static_cast<int>(param.largest()) ? static_cast<int>(param.smallest())
                                                                         : std::get<int>(usual) + 1;
    case Param::Type::Real:
        return std::get<double>(usual) == param.largest() ? param.smallest() : param.largest();
    case Param::Type::Choice:
        return param.choices().front().id == std::get<std::string>(usual) ? param.choices().back().id
                                                                          : param.choices().front().id;
    case Param::Type::Area:
    case Param::Type::Size:
    case Param::Type::Points:
        break; // of tools alone
    }
    return usual;
}

ParamRow* rowOf(const Inspector& inspector, const std::string& name) {
    for (ParamRow* row : inspector.rows())
        if (row->param().name() == name)
            return row;
    return nullptr;
}

} // namespace

class InspectorTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyMethodHasARowForEachParameter_data() {
        QTest::addColumn<QString>("id");
        for (const Method& method : methods())
            QTest::newRow(method.id().c_str()) << QString::fromStdString(method.id());
    }

    void everyMethodHasARowForEachParameter() {
        QFETCH(QString, id);
        const Method& method = findMethod(id.toStdString());
        Inspector inspector;
        inspector.setMethod(method);
        QCOMPARE(inspector.rows().size(), method.params().size());
        QVERIFY(inspector.values() == method.defaults());
        for (ParamRow* row : inspector.rows()) {
            QVERIFY(row->label()->buddy() == row->editor());
            QVERIFY(!row->resetButton()->accessibleName().isEmpty());
            QVERIFY(!row->param().help().empty());
            QVERIFY(row->helpText().contains(QString::fromStdString(row->param().help()).toHtmlEscaped()));
            QVERIFY(row->editor()->value() == row->value());
        }
    }

    void methodsFollowEachOther() {
        Inspector inspector;
        inspector.setMethod(findMethod("random-phase"));
        QVERIFY(inspector.then().empty());
        auto* chooser = child<QComboBox>(inspector, "then1");
        QCOMPARE(chooser->findData(QStringLiteral("random-phase")), -1);
        QSignalSpy edited(&inspector, &Inspector::edited);
        chooser->setCurrentIndex(chooser->findData(QStringLiteral("quilting")));
        QVERIFY(!edited.isEmpty());
        QCOMPARE(inspector.then().size(), 1U);
        QVERIFY(inspector.then()[0].parameters == findMethod("quilting").defaults());
        QVERIFY(!useOf(inspector.steps()).several);

        inspector.setThen({{"quilting", {{"patch", 20}}}, {"quilting", {{"patch", 10}}}});
        QCOMPARE(inspector.then().size(), 2U);
        QVERIFY(inspector.then()[0].parameters.at("patch") == Value(20));
        QVERIFY(inspector.then()[1].parameters.at("patch") == Value(10));
        inspector.resetAll();
        QVERIFY(inspector.then()[1].parameters == findMethod("quilting").defaults());
        chooser->setCurrentIndex(0);
        QVERIFY(inspector.then().empty());
    }

    void changedValuesAreBoldAndResetTakesThemBack_data() { everyMethodHasARowForEachParameter_data(); }

    void changedValuesAreBoldAndResetTakesThemBack() {
        QFETCH(QString, id);
        Inspector inspector;
        inspector.setMethod(findMethod(id.toStdString()));
        for (ParamRow* row : inspector.rows()) {
            const Value usual = row->value();
            row->setApplies(true, {});
            QVERIFY(!row->changed() && !row->label()->font().bold() && row->resetButton()->isHidden());
            row->setValue(otherValue(row->param()));
            QVERIFY(row->changed() && row->label()->font().bold() && !row->resetButton()->isHidden());
            row->resetButton()->click();
            QVERIFY(row->value() == usual && !row->changed() && !row->label()->font().bold());
            row->setValue(otherValue(row->param()));
            row->setApplies(true, {});
            QTest::mouseDClick(row->label(), Qt::LeftButton);
            QVERIFY(row->value() == usual);
        }
    }

    void rowsWithoutEffectAreDisabled() {
        for (const Method& method : methods()) {
            Inspector inspector;
            inspector.setMethod(method);
            for (ParamRow* row : inspector.rows()) {
                const auto& condition = row->param().condition();
                QCOMPARE(row->editor()->isEnabled(), row->param().applies(inspector.values()));
                if (!condition)
                    continue;
                ParamRow* const ruling = rowOf(inspector, condition->name);
                inspector.setValues({{condition->name, condition->value}});
                QVERIFY(row->editor()->isEnabled());
                inspector.setValues({{condition->name, otherValue(ruling->param())}});
                if (inspector.values()[condition->name] != condition->value)
                    QVERIFY(!row->editor()->isEnabled());
            }
        }
    }

    void defaultsScaleUnlessChanged() {
        for (const Method& method : methods()) {
            Inspector inspector;
            inspector.setMethod(method);
            for (const int side : {200, 400}) {
                inspector.setExemplarSize({side, side + 100});
                QVERIFY(inspector.values() == method.defaults({side, side + 100}));
            }
            for (ParamRow* row : inspector.rows()) {
                if (!row->param().scale())
                    continue;
                QVERIFY(row->helpText().contains(QStringLiteral("shorter side")));
                const Value chosen = otherValue(row->param());
                row->setValue(chosen);
                inspector.setExemplarSize({300, 300});
                QVERIFY(row->value() == chosen);
            }
        }
    }

    void sliderAndSpinBoxAreInStep() {
        for (const Method& method : methods()) {
            Inspector inspector;
            inspector.setMethod(method);
            for (ParamRow* row : inspector.rows()) {
                auto* slider = row->editor()->findChild<QSlider*>();
                if (slider == nullptr)
                    continue;
                row->editor()->setEnabled(true);
                slider->setValue(slider->maximum());
                const Value largest = row->param().type() == Param::Type::Integer
                                          ? Value(static_cast<int>(row->param().largest()))
                                          : Value(row->param().usualTo());
                QVERIFY(row->value() == largest);
                row->setValue(row->param().checked(row->param().defaultFor(0)));
                QVERIFY(slider->value() < slider->maximum() || row->value() == largest);
            }
        }
    }

    void focusShowsHelpInWords() {
        Inspector inspector;
        inspector.setMethod(methods().front());
        inspector.show();
        QVERIFY(QTest::qWaitForWindowActive(&inspector));
        ParamRow* const row = inspector.rows().front();
        row->editor()->setFocus();
        QTRY_COMPARE(inspector.help(), row->helpText());
    }

    void outputSettings() {
        OutputGroup output;
        output.setExemplarSize({100, 60});
        QVERIFY((output.outputSize() == Size{200, 120}));
        child<QToolButton>(output, "sizeTimes4")->click();
        QVERIFY((output.outputSize() == Size{400, 240}));
        output.setExemplarSize({50, 50});
        QVERIFY((output.outputSize() == Size{400, 240}));
        output.setOutputSize({1 << 20, 0});
        QVERIFY((output.outputSize() == Size{kLargestSide, 1}));
        QCOMPARE(output.threads(), 0);
    }

    void wrapIsGreyWithTheReasonWhereAMethodCannot() {
        OutputGroup output;
        MethodInfo info;
        info.title = "Plain";
        info.gives = {ports::wrappingImage()};
        output.setMethod(info);
        output.setWrap({true, true});
        QVERIFY((output.wrap() == Wrap{true, true}));
        info.gives = {ports::image()};
        output.setMethod(info);
        QVERIFY((output.wrap() == Wrap{}));
        auto* box = child<QCheckBox>(output, "wrapX");
        QVERIFY(!box->isEnabled());
        QVERIFY(box->toolTip().contains(QStringLiteral("Plain cannot")));
    }

    void seedsHave64Bits() {
        SeedEdit edit;
        QSignalSpy changed(&edit, &SeedEdit::seedChanged);
        const auto largest = std::numeric_limits<std::uint64_t>::max();
        edit.setSeed(largest);
        QCOMPARE(edit.seed(), largest);
        edit.stepBy(1);
        QCOMPARE(edit.seed(), largest);
        edit.setSeed(5);
        edit.stepBy(-10);
        QCOMPARE(edit.seed(), 0U);
        QString text = QStringLiteral("18446744073709551616");
        int position = 0;
        QCOMPARE(edit.validate(text, position), QValidator::Invalid);
        edit.draw();
        QVERIFY(edit.seed() > 0);
        QCOMPARE(changed.size(), 4);
    }
};

TEXLOOM_UI_TESTS(InspectorTest)
#include "inspector_test.moc"
