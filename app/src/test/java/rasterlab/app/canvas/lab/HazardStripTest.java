package rasterlab.app.canvas.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Insets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.method.TopicColors;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.engine.study.Verdict;

class HazardStripTest {
    private static final TopicColors NONE = new TopicColors(Map.of());

    private final JPanel chips = new JPanel();
    private String input = "first";
    private String method = "right";
    private HazardStrip strip;

    @BeforeEach
    void tell() {
        LabTheme.LIGHT.install();
        if (strip == null) strip = new HazardStrip(Texts.of("canvas", Language.ENGLISH));
        strip.of(new LabInput(() -> input, () -> method, chosen -> method = chosen, NONE));
        var hazard =
                new HazardCase(
                        "steep",
                        "Steep",
                        "Above 45° there are more rows than columns.",
                        List.of("wrong", "right", "endless"),
                        Map.of(
                                "right", Verdict.Kind.EXACT,
                                "wrong", Verdict.Kind.WRONG,
                                "endless", Verdict.Kind.ENDLESS),
                        () -> input = "steep");
        hazard.show().run();
        strip.tell(hazard, chips);
    }

    @Test
    @DisplayName("a clicked hazard does not say what is special, or how the method does there")
    void saysWhatIsSpecialAndTheVerdict() {
        assertTrue(strip.isVisible());
        assertEquals(
                "“Steep”: Above 45° there are more rows than columns.",
                ((WrappedText) named("hazard.special").orElseThrow()).getText());
        assertEquals("right: exact", verdict());
        assertEquals(List.of("hazard.method.wrong", "hazard.method.endless"), choices());
    }

    @Test
    @DisplayName("a button does not switch to the method that fails, or there is no way back")
    void buttonsChooseTheMethodsThatFail() {
        button("hazard.method.wrong").doClick();
        assertEquals("wrong", method);
        assertEquals("wrong: wrong", verdict());
        assertEquals(List.of("hazard.method.endless", "hazard.method.right"), choices());
        button("hazard.method.right").doClick();
        assertEquals("right: exact", verdict());
    }

    @Test
    @DisplayName("the way back to an exact method is listed among those that fail")
    void theWayBackHasWordsOfItsOwn() {
        assertFalse(rowTexts().contains("Back to:"), rowTexts().toString());
        button("hazard.method.endless").doClick();
        assertEquals(
                List.of(
                        "endless: endless",
                        "Not exact here:",
                        "wrong: wrong",
                        "Back to:",
                        "right: exact"),
                rowTexts());
    }

    @Test
    @DisplayName("the clicked chip is marked only while it has the keyboard, or for ever")
    void itsChipIsMarkedAsLongAsItIsTold() {
        var row = new Chips(Texts.of("line", Language.ENGLISH), "hazards");
        for (String name : List.of("steep", "flat")) row.add(name, name, "", () -> {});
        strip.tell(HazardCase.unjudged("steep", "steep", "", () -> {}), row);
        assertEquals(List.of("chip.steep"), marked(row));
        strip.tell(HazardCase.unjudged("flat", "flat", "", () -> {}), row);
        assertEquals(List.of("chip.flat"), marked(row));
        input = "moved";
        strip.refresh();
        assertEquals(List.of("chip.flat"), marked(row));
        button("hazard.close").doClick();
        assertEquals(List.of(), marked(row));
        strip.tell(HazardCase.unjudged("flat", "flat", "", () -> {}), row);
        tell();
        assertEquals(List.of(), marked(row), "another row's hazard is told");
    }

    private static List<String> marked(Chips row) {
        return Stream.of(row.getComponents())
                .filter(each -> each instanceof JButton chip && chip.isSelected())
                .filter(each -> !"chips.more".equals(each.getName()))
                .map(Component::getName)
                .toList();
    }

    @Test
    void hasAnEdgeAllAround() {
        assertEquals(new Insets(1, 1, 1, 1), strip.getBorder().getBorderInsets(strip));
    }

    /** The texts of the row, in its order. */
    private List<String> rowTexts() {
        Container row = named("hazard.verdict").orElseThrow().getParent();
        return Stream.of(row.getComponents())
                .map(
                        part ->
                                part instanceof JLabel label
                                        ? label.getText()
                                        : ((JButton) part).getText())
                .toList();
    }

    @Test
    @DisplayName("verdicts stay beside an input that was changed")
    void changedInputHasNoVerdicts() {
        input = "moved";
        strip.refresh();
        assertEquals(List.of(), choices());
        assertTrue(strip.isVisible(), "the stage changes its size while the input is dragged");
        button("hazard.again").doClick();
        assertEquals("steep", input);
        assertEquals("right: exact", verdict());
    }

    @Test
    void itsHeightStaysWhileTheInputIsChanged() {
        strip.setSize(160, 300);
        strip.doLayout();
        int before = strip.getPreferredSize().height;
        input = "moved";
        strip.refresh();
        assertEquals(before, strip.getPreferredSize().height);
    }

    @Test
    void goesWithItsChipsOrWhenItIsClosed() {
        chips.setVisible(false);
        strip.refresh();
        assertFalse(strip.isVisible(), "another mode is shown");
        chips.setVisible(true);
        tell();
        button("hazard.close").doClick();
        assertFalse(strip.isVisible());
    }

    @Test
    @DisplayName("verdicts that are found later are not told, or beside another hazard")
    void tellsVerdictsThatAreFoundLater() {
        strip.tell(HazardCase.unjudged("view", "View", "Faces in a circle.", () -> {}), chips);
        strip.judging();
        assertEquals(List.of(), choices());
        strip.judge("other", Map.of("wrong", Verdict.Kind.WRONG));
        assertEquals(List.of(), choices());
        strip.judge("view", Map.of("wrong", Verdict.Kind.WRONG, "right", Verdict.Kind.EXACT));
        assertEquals("right: exact", verdict());
        assertEquals(List.of("hazard.method.wrong"), choices());
    }

    @Test
    @DisplayName("where no method is judged nothing is said of it, or it is said beside verdicts")
    void saysWhyNoMethodIsJudged() {
        strip.of(LabInput.unjudged(() -> input, "Both are drawn."));
        strip.tell(HazardCase.unjudged("view", "View", "Faces in a circle.", () -> {}), chips);
        WrappedText why = (WrappedText) named("hazard.unjudged").orElseThrow();
        assertTrue(why.isVisible());
        assertEquals("Both are drawn.", why.getText());
        strip.judging();
        assertFalse(why.isVisible(), "verdicts are being found");
        strip.judge("view", Map.of("right", Verdict.Kind.EXACT));
        assertFalse(why.isVisible(), "there are verdicts");
        tell();
        assertFalse(((WrappedText) named("hazard.unjudged").orElseThrow()).isVisible());
    }

    @Test
    @DisplayName("verdicts beside a hazard that is not judged leave a gap below them")
    void itsHeightIsThatOfItsOwnHazard() {
        strip.setSize(600, 300);
        strip.doLayout();
        int alone = strip.getPreferredSize().height;
        strip.setSize(60, 300);
        strip.doLayout();
        strip.of(
                new LabInput(
                        () -> input,
                        () -> method,
                        chosen -> method = chosen,
                        NONE,
                        name -> name,
                        "Both are drawn beside each other. ".repeat(8)));
        strip.tell(HazardCase.unjudged("view", "View", "In a circle.", () -> {}), chips);
        strip.setSize(600, 300);
        strip.doLayout();
        strip.tell(
                new HazardCase(
                        "steep",
                        "Steep",
                        "Above 45° there are more rows than columns.",
                        List.of("wrong", "right", "endless"),
                        Map.of(
                                "right", Verdict.Kind.EXACT,
                                "wrong", Verdict.Kind.WRONG,
                                "endless", Verdict.Kind.ENDLESS),
                        () -> {}),
                chips);
        assertEquals(alone, strip.getPreferredSize().height);
    }

    @Test
    @DisplayName("a method is called by its code where the lab has a name for it")
    void callsMethodsAsTheLabDoes() {
        strip.of(
                new LabInput(
                        () -> input,
                        () -> method,
                        chosen -> method = chosen,
                        NONE,
                        name -> "the " + name + " one",
                        ""));
        strip.refresh();
        assertEquals("the right one: exact", verdict());
    }

    private String verdict() {
        return ((JLabel) named("hazard.verdict").orElseThrow()).getText();
    }

    private List<String> choices() {
        return parts(strip)
                .map(part -> String.valueOf(part.getName()))
                .filter(name -> name.startsWith("hazard.method."))
                .toList();
    }

    private JButton button(String name) {
        return (JButton) named(name).orElseThrow();
    }

    private Optional<Component> named(String name) {
        return parts(strip).filter(part -> name.equals(part.getName())).findFirst();
    }

    private static Stream<Component> parts(Container parent) {
        var all = new ArrayList<Component>();
        for (Component each : parent.getComponents()) {
            all.add(each);
            if (each instanceof Container inner) all.addAll(parts(inner).toList());
        }
        return all.stream();
    }
}
