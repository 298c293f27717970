package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import javax.swing.JPanel;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.data.TableCell;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.language.Language;
import rasterlab.app.rooms.LabRooms;
import rasterlab.app.study.StudyLabState;
import rasterlab.app.study.StudyView;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.ParetoFront;
import rasterlab.engine.study.Study;
import rasterlab.tests.bench.window.WindowContent;

/** The tab of speed and accuracy under a real display, by mouse and keyboard. */
@Timeout(300)
class WindowStudyTest extends WindowHarness {
    @BeforeEach
    void showStudy() {
        if (window != null) showHazards();
    }

    private StudyLabState state() {
        return GuiActionRunner.execute(() -> models.study().state());
    }

    /** A topic that is measured in a second, where lines take ten. */
    private void measureSmallTopic() {
        window.comboBox("topic").selectItem("shading of a point");
        window.button("measure").click();
        await("measured", () -> state().study().isPresent() && !state().work().running());
        await("the chart is drawn", () -> colors("chart").contains(colorOfTheQuickest()));
    }

    /** The method that nothing beats and that is therefore not pale. */
    private int colorOfTheQuickest() {
        Study study = state().study().orElseThrow();
        ParetoFront front = ParetoFront.of(study, ParetoFront.telling(study));
        List<String> methods = state().topic().methods().stream().map(Method::name).toList();
        String quickest = front.front().get(0).method();
        return LabRooms.card("shade").colors().among(methods).get(quickest).getRGB();
    }

    @Test
    void measuresAndWalksFromPointToPoint() {
        measureSmallTopic();
        assertEquals(StudyView.CHART, state().view());
        focus("chart");
        press(KeyEvent.VK_RIGHT);
        Measurement cheaper = state().point().orElseThrow();
        press(KeyEvent.VK_RIGHT);
        Measurement point = state().point().orElseThrow();
        assertTrue(
                cheaper.cost().medianNanos() <= point.cost().medianNanos(),
                cheaper + " before " + point);
        assertNotEquals(cheaper.method(), point.method());
        assertEquals(point.method(), state().method());
        assertTrue(window.textBox("detail").text().contains(point.method()));
        press(KeyEvent.VK_LEFT);
        assertEquals(cheaper, state().point().orElseThrow());
    }

    @Test
    void clickChoosesThePointThatIsThere() {
        measureSmallTopic();
        Component chart = window.robot().finder().findByName(frame, "chart");
        BufferedImage seen = captured("chart");
        int wanted = colorOfTheQuickest();
        for (int x = chart.getWidth() / 8; x < chart.getWidth() * 3 / 4; x += 3)
            for (int y = 0; y < chart.getHeight(); y += 3) {
                if ((0xFF000000 | seen.getRGB(x, y)) != wanted) continue;
                robot.click(chart, new Point(x, y), MouseButton.LEFT_BUTTON, 1);
                robot.waitForIdle();
                if (state().point().isPresent()) return;
            }
        throw new AssertionError("no point of the quickest method is there");
    }

    @Test
    void cellOfTheTableIsExplainedAndOpensItsSceneInItsTab() {
        window.table("hazards").selectCell(TableCell.row(0).column(0));
        robot.waitForIdle();
        var topic = state().topic();
        assertEquals(topic.hazards().get(0).name(), state().hazard());
        assertEquals(topic.methods().get(0).name(), state().method());
        window.button("open").click();
        robot.waitForIdle();
        assertEquals("line", WindowContent.of(frame).shown());
        var input = (rasterlab.engine.line.Segment) topic.hazards().get(0).input();
        assertEquals(input, segment());
    }

    @Test
    void enterOpensTheCellToo() {
        window.comboBox("topic").selectItem("curve by control points");
        robot.waitForIdle();
        window.table("hazards").selectCell(TableCell.row(1).column(1));
        focus("hazards");
        press(KeyEvent.VK_ENTER);
        assertEquals("spline", WindowContent.of(frame).shown());
    }

    @Test
    void rowOfDepthsOpensBesideTheScenes() {
        window.comboBox("topic").selectItem("depth buffer");
        robot.waitForIdle();
        window.table("hazards").selectCell(TableCell.row(2).column(1));
        robot.waitForIdle();
        assertTrue(window.textBox("input").text().length() > 10);
        window.button("open").click();
        robot.waitForIdle();
        assertEquals("visibility", WindowContent.of(frame).shown());
        JPanel rows = window.panel("rows").target();
        assertEquals("z24", window.panel("rows").comboBox("method").selectedItem());
        window.panel("rows").comboBox("mode").selectItem(0);
        robot.waitForIdle();
        assertFalse(GuiActionRunner.execute(rows::isShowing));
    }

    @Test
    void namesOfHazardsStayWhereMethodsScroll() {
        window.comboBox("topic").selectItem("hidden surfaces");
        window.resizeTo(new Dimension(900, 600));
        robot.waitForIdle();
        var names = window.table("hazards.names");
        Point before = names.target().getLocationOnScreen();
        int last = state().topic().methods().size() - 1;
        window.table("hazards").selectCell(TableCell.row(3).column(last));
        robot.waitForIdle();
        assertTrue(window.table("hazards").target().getVisibleRect().x > 0, "methods scrolled");
        assertEquals(before, names.target().getLocationOnScreen());
        assertEquals(names.target().getVisibleRect().width, names.target().getWidth());
        assertEquals(3, names.target().getSelectedRow());
    }

    @Test
    void triesHazardsAndMarksThem() {
        window.button("tryHazards").click();
        await(
                "all are tried",
                () -> {
                    var topic = state().topic();
                    return state().cells().size()
                            == topic.hazards().size() * topic.methods().size();
                });
        assertEquals(StudyView.HAZARDS, state().view());
        window.progressBar("progress").requireText("every method tried on every hazard");
        assertFalse(state().cells().stream().anyMatch(cell -> !cell.asRecorded()));
    }

    @Test
    void cancelledMeasurementLeavesNothingHalfDone() {
        await("the result that ships is shown", () -> state().study().isPresent());
        var shipped = state().study();
        window.comboBox("pace").selectItem(1);
        window.button("measure").click();
        window.button("cancel").click();
        await("it is given up", () -> window.button("measure").isEnabled());
        assertTrue(state().thorough());
        assertEquals(shipped, state().study());
    }

    @Test
    void keyboardIsBackOnTheButtonThatBeganTheRun() {
        measureSmallTopic();
        var button = window.button("measure").target();
        await("the keyboard is on the button", () -> GuiActionRunner.execute(button::isFocusOwner));
    }

    @Test
    void savesWhatWasMeasured() {
        measureSmallTopic();
        var file = folder.resolve("shade.csv");
        window.button("save").click();
        window.fileChooser().setCurrentDirectory(folder.toFile());
        window.fileChooser().fileNameTextBox().setText(file.toString());
        window.fileChooser().fileNameTextBox().pressAndReleaseKeys(KeyEvent.VK_ENTER);
        await("the file is there", () -> java.nio.file.Files.exists(file));
    }

    @Test
    void languageKeepsTopicViewAndChoice() {
        window.comboBox("topic").selectItem("clipping of segments");
        window.table("hazards").selectCell(TableCell.row(2).column(1));
        robot.waitForIdle();
        var before = state();
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        window.resizeTo(new Dimension(900, 600));
        robot.waitForIdle();
        assertEquals(before, state());
        assertEquals("study", WindowContent.of(frame).shown());
    }
}
