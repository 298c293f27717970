package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.swing.JComponent;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.engine.Topics;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

class HazardTableTest {
    @BeforeEach
    @AfterEach
    void usualTheme() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
    }

    private static StudyLabModel lines() {
        return new StudyLabModel(
                List.of(new LineTopic()),
                Runnable::run,
                failure -> {
                    throw new AssertionError(failure);
                });
    }

    @ParameterizedTest(name = "{0}: a recorded verdict drowns")
    @EnumSource(LabTheme.class)
    void recordedVerdictsCanBeRead(LabTheme theme) throws Exception {
        EventQueue.invokeAndWait(theme::install);
        try (var model = lines()) {
            var table = new HazardTable(model, Texts.of("study", Language.ENGLISH), () -> {});
            table.refresh();
            var cell = table.prepareRenderer(table.getCellRenderer(0, 0), 0, 0);
            double contrast = MethodColors.contrast(cell.getForeground(), cell.getBackground());
            assertTrue(contrast >= 4.5, () -> "contrast " + contrast);
        }
    }

    @Test
    @DisplayName("the projector's largest signs are dots")
    void columnsAreAsWideAsTheirSigns() throws Exception {
        EventQueue.invokeAndWait(() -> LabTheme.PROJECTOR.install(200));
        try (var model = lines()) {
            var table = new HazardTable(model, Texts.of("study", Language.ENGLISH), () -> {});
            table.scroll();
            table.refresh();
            int needed =
                    table.prepareRenderer(table.getCellRenderer(0, 0), 0, 0)
                            .getPreferredSize()
                            .width;
            assertTrue(table.getColumnModel().getColumn(0).getWidth() >= needed, "needs " + needed);
        }
    }

    @Test
    @DisplayName("a third of a wide window stays empty beside the methods")
    void columnsFillTheRoom() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
        try (var model = lines()) {
            var table = new HazardTable(model, Texts.of("study", Language.ENGLISH), () -> {});
            var viewport = table.scroll().getViewport();
            table.refresh();
            int columns = table.getColumnCount();
            viewport.setSize(70 * columns + 5, 500);
            assertEquals(70 * columns, table.getPreferredSize().width);
            viewport.setSize(columns, 500);
            assertTrue(table.getPreferredSize().width > 40 * columns, "signs cut off");
        }
    }

    @Test
    @DisplayName("two fifths of a high window stay empty below the hazards")
    void rowsFillTheRoom() throws Exception {
        try (var model = lines()) {
            var table = new HazardTable(model, Texts.of("study", Language.ENGLISH), () -> {});
            var scroll = table.scroll();
            table.refresh();
            int least = table.getRowHeight();
            int rows = table.getRowCount();
            scroll.getViewport().setSize(500, (least + 9) * rows + 5);
            var names = (JTable) scroll.getRowHeader().getView();
            assertEquals(least + 9, table.getRowHeight());
            assertEquals(least + 9, names.getRowHeight());
            scroll.getViewport().setSize(500, 10 * least * rows);
            assertEquals(2 * least, table.getRowHeight());
            scroll.getViewport().setSize(500, rows);
            assertEquals(least, table.getRowHeight());
        }
    }

    @Test
    @DisplayName("the drawing of the table lacks a method, a hazard or the verdicts")
    void svgHasTheWholeTable() {
        List<Throwable> failures = new ArrayList<>();
        try (var model =
                new StudyLabModel(List.of(new LineTopic()), Runnable::run, failures::add)) {
            var table = new HazardTable(model, Texts.of("study", Language.ENGLISH), () -> {});
            table.scroll();
            table.refresh();
            String svg = table.svg().document();
            BufferedImage dots = table.dots();
            assertTrue(svg.contains("width=\"" + dots.getWidth() + "\""), dots.toString());
            assertTrue(svg.contains("height=\"" + dots.getHeight() + "\""), dots.toString());
            for (Method<?> method : model.state().topic().methods())
                assertTrue(svg.contains(">" + method.name() + "<"), method.name());
            TopicNames called = TopicNames.in(Language.ENGLISH);
            for (Hazard<?> hazard : model.state().topic().hazards())
                assertTrue(
                        svg.contains(">" + called.hazard(model.state().topic(), hazard) + "<"),
                        hazard.name());
            int methods = model.state().topic().methods().size();
            int hazards = model.state().topic().hazards().size();
            long verdicts = svg.chars().filter(sign -> "✓≈✗⊘∞†".indexOf(sign) >= 0).count();
            assertEquals(methods * hazards, verdicts);
        }
        assertEquals(List.of(), failures);
    }

    @Test
    @DisplayName("the head of the names stands beside its column")
    void headBeginsWhereTheNamesBegin() {
        List<Throwable> failures = new ArrayList<>();
        try (var model =
                new StudyLabModel(List.of(new LineTopic()), Runnable::run, failures::add)) {
            var table = new HazardTable(model, Texts.of("study", Language.ENGLISH), () -> {});
            var scroll = table.scroll();
            table.refresh();
            var names = (JTable) scroll.getRowHeader().getView();
            var head = names.getTableHeader().getDefaultRenderer();
            var cell = names.getDefaultRenderer(Object.class);
            assertEquals(
                    firstInk(cell.getTableCellRendererComponent(names, "H", false, false, 0, 0)),
                    firstInk(head.getTableCellRendererComponent(names, "H", false, false, -1, 0)));
        }
        assertEquals(List.of(), failures);
    }

    /** The leftmost column in which something is drawn. */
    private static int firstInk(Component drawn) {
        drawn.setSize(90, 40);
        var image = new BufferedImage(90, 40, BufferedImage.TYPE_INT_RGB);
        var g = image.createGraphics();
        g.setColor(drawn.getBackground());
        g.fillRect(0, 0, 90, 40);
        drawn.paint(g);
        g.dispose();
        for (int x = 0; x < 90; x++)
            for (int y = 0; y < 36; y++) if (image.getRGB(x, y) != image.getRGB(x, 0)) return x;
        throw new AssertionError("nothing is drawn");
    }

    @Test
    @DisplayName("the table or its tips have names that only commands use")
    void tableAndItsTipsHaveTitles() {
        List<Throwable> failures = new ArrayList<>();
        try (var model = new StudyLabModel(Topics.all(), Runnable::run, failures::add)) {
            model.choose("triangulate");
            Map.of(Language.RUSSIAN, "Треугольник", Language.ENGLISH, "Triangle")
                    .forEach((language, title) -> isTitled(model, language, title));
        }
        assertEquals(List.of(), failures);
    }

    private static void isTitled(StudyLabModel model, Language language, String title) {
        var table = new HazardTable(model, Texts.of("study", language), () -> {});
        var names = (JTable) table.scroll().getRowHeader().getView();
        table.refresh();
        assertEquals(title, names.getValueAt(0, 0));
        var cell = names.prepareRenderer(names.getCellRenderer(0, 0), 0, 0);
        assertEquals(title, ((JComponent) cell).getToolTipText());
        var verdict = table.prepareRenderer(table.getCellRenderer(0, 0), 0, 0);
        String tip = ((JComponent) verdict).getToolTipText();
        assertTrue(tip.contains(title), tip);
        assertFalse(tip.contains("one-triangle"), tip);
    }
}
