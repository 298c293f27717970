package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.imageio.ImageIO;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JTextArea;
import javax.swing.ListCellRenderer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabTheme;

class OpenGlInspectorTest {
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final OpenGlLabModel model = new OpenGlLabModel(EventQueue::invokeLater, failures::add);
    private OpenGlInspector inspector;

    @BeforeAll
    static void lookLikeTheLab() {
        LabTheme.LIGHT.install();
    }

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private void open(Path file) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    inspector = new OpenGlInspector(model, Texts.of("opengl", Language.ENGLISH));
                    inspector.sections().forEach(Runnable::run);
                    model.open(file);
                });
        model.settle();
        EventQueue.invokeAndWait(() -> inspector.refresh());
    }

    private Component named(String name) {
        return Arrays.stream(inspector.column().getComponents())
                .filter(each -> name.equals(each.getName()))
                .findFirst()
                .orElseThrow();
    }

    private static String shown(JComboBox<?> list) {
        return shownBy(list, list.getSelectedItem());
    }

    @SuppressWarnings("unchecked")
    private static String shownBy(JComboBox<?> list, Object item) {
        var renderer = (ListCellRenderer<Object>) list.getRenderer();
        var label = renderer.getListCellRendererComponent(new JList<>(), item, -1, false, false);
        return ((JLabel) label).getText();
    }

    private int place(String name) {
        return inspector.column().getComponentZOrder(named(name));
    }

    @Test
    @DisplayName("why an image is refused stands far below its button, in Java's words")
    void refusalStandsUnderTheButton(@TempDir Path folder) throws Exception {
        byte[] begun = {
            (byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R'
        };
        Path file = Files.write(folder.resolve("half.png"), begun);
        open(file);
        assertTrue(named("problem").isVisible(), "not in sight");
        assertEquals(
                file
                        + ": the picture is cut off: the file ends too early; allowed are whole"
                        + " pictures as PNG, JPEG, GIF or BMP",
                ((JTextArea) named("problem")).getText());
        assertEquals(place("open") + 1, place("problem"));
    }

    @Test
    @DisplayName("a size can be chosen for an image that has its own")
    void fileHasItsOwnSize(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("flag.png");
        ImageIO.write(new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
        open(file);
        assertFalse(named("size").isEnabled());
        assertEquals("4 × 2", shown((JComboBox<?>) named("size")));
        assertEquals("from flag.png", shown((JComboBox<?>) named("image")));
        assertFalse(named("problem").isVisible(), "a word of a problem that there is not");
    }
}
