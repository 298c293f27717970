package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.Icon;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.visibility.scene.HazardView;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.PixelMark;

/** The text of the inspector about wrong pixels. */
@Timeout(300)
class WrongRowsTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final VisibilityLabModel model =
            new VisibilityLabModel(new OwnMethods(), new Renderer()::render, thread, failures::add);
    private Texts texts = Texts.of("visibility", Language.ENGLISH);
    private VisibilityInspector inspector;

    @BeforeEach
    void open() {
        model.resize(120, 80);
        show();
    }

    private void show() {
        inspector =
                new VisibilityInspector(
                        model, texts, new SceneSaving(model, texts, (t, s, w, done) -> {}));
        inspector.sections().forEach(Runnable::run);
        thread.settle(model::settle);
        inspector.refresh();
    }

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private JLabel value(String key) {
        return labels(inspector.column()).stream()
                .filter(label -> (key + ".value").equals(label.getName()))
                .findFirst()
                .orElseThrow();
    }

    private static List<JLabel> labels(Container container) {
        var found = new ArrayList<JLabel>();
        for (Component child : container.getComponents()) {
            if (child instanceof JLabel label) found.add(label);
            if (child instanceof Container inner) found.addAll(labels(inner));
        }
        return found;
    }

    private static HashSet<Integer> colors(Icon icon, Component on) {
        var image = new BufferedImage(40, 40, BufferedImage.TYPE_INT_RGB);
        icon.paintIcon(on, image.getGraphics(), 4, 4);
        var colors = new HashSet<Integer>();
        for (int i = 0; i < 1600; i++) colors.add(image.getRGB(i % 40, i / 40));
        return colors;
    }

    @Test
    @DisplayName("two methods' counts do not say whose they are, or one stands only with marks")
    void countsNameTheirMethods() {
        model.choose(choice -> choice.withScene("cyclic-overlap").inOwnColors());
        model.choose(choice -> choice.withComparison("newell"));
        show();
        assertTrue(value("wrongPixels").getText().matches("painter: [1-9][0-9,]*"));
        assertEquals("newell: 0", value("other").getText());
        assertTrue(value("other").isVisible(), "shown only with marks");
        for (String[] one : new String[][] {{"wrongPixels", "painter"}, {"other", "newell"}}) {
            JLabel value = value(one[0]);
            int color = VisibilityColors.OWN.of(one[1]).getRGB();
            assertTrue(colors(value.getIcon(), value).contains(color), one[1]);
        }
        model.choose(choice -> choice.withComparison(""));
        thread.settle(model::settle);
        inspector.refresh();
        assertTrue(value("wrongPixels").getText().matches("[0-9]+ pixels"));
        assertTrue(!value("other").isVisible() && value("wrongPixels").getIcon() == null);
    }

    @Test
    @DisplayName("a count that is not made is waited for for ever")
    void countThatIsNotMadeIsNotWaitedFor() {
        model.compareColors("cyclic-overlap", "painter", "newell");
        model.turn(0.1, 0);
        thread.settle(model::settle);
        inspector.refresh();
        assertEquals("painter: –", value("wrongPixels").getText());
        assertEquals("newell: –", value("other").getText());
    }

    @Test
    @DisplayName("a count that a refusal ends is waited for for ever, or ends the other one too")
    void refusalOfOneMethodIsSaidAndTheOtherIsCounted() {
        model.choose(choice -> choice.comparing("cyclic-overlap", OwnMethods.NAME, "newell"));
        model.choose(choice -> choice.withDifference(true));
        thread.settle(model::settle);
        inspector.refresh();
        assertEquals("my program: no answer", value("wrongPixels").getText());
        String why = value("wrongPixels").getToolTipText();
        assertTrue(why.startsWith("There is no program of yours yet"), why);
        assertEquals("–", value("missing").getText());
        assertEquals("–", value("share").getText());
        assertEquals("newell: 0", value("other").getText());
        model.choose(
                choice ->
                        choice.comparing("cyclic-overlap", "painter", OwnMethods.NAME)
                                .withDifference(true));
        thread.settle(model::settle);
        inspector.refresh();
        assertTrue(value("wrongPixels").getText().matches("painter: [1-9][0-9,]*"));
        assertNull(value("wrongPixels").getToolTipText());
        assertEquals("my program: no answer", value("other").getText());
        model.choose(
                choice ->
                        choice.comparing("cyclic-overlap", OwnMethods.NAME, "")
                                .withDifference(true));
        thread.settle(model::settle);
        inspector.refresh();
        assertEquals("no answer", value("wrongPixels").getText());
    }

    @Test
    @DisplayName("a view that differs by the eye alone is not counted until something else changes")
    void viewOfAChipIsCounted() {
        model.choose(HazardView.OPENING::shown);
        model.turn(0.1, 0);
        model.choose(HazardView.OPENING::shown);
        thread.settle(model::settle);
        inspector.refresh();
        String counted = value("wrongPixels").getText();
        assertTrue(counted.matches("[0-9]+ pixels?"), counted);
        model.zoom(1.25);
        thread.settle(model::settle);
        inspector.refresh();
        assertEquals("–", value("wrongPixels").getText(), "counted while the eye moves");
    }

    @ParameterizedTest(name = "the sign of wrong faces has other colours than marked areas: {0}")
    @EnumSource(Language.class)
    void signOfWrongFacesIsInTheColorsOfTheMarks(Language language) {
        texts = Texts.of("visibility", language);
        show();
        JLabel value = value("miscoloured");
        HashSet<Integer> colors = colors(value.getIcon(), value);
        assertTrue(colors.contains(PixelMark.ARGB));
        assertTrue(colors.contains(PictureDifference.EDGE));
        for (JLabel label : labels(inspector.column()))
            if (label.getLabelFor() == value)
                assertTrue(label.getText().matches("[\\p{L} ]+"), label.getText());
    }
}
