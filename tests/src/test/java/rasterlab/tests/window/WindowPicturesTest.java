package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.xml.parsers.DocumentBuilderFactory;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.w3c.dom.Element;
import rasterlab.app.shell.LabTabs;

/** Pictures of every lab as files, saved in the window under a real display. */
class WindowPicturesTest extends WindowHarness {
    /** Saves by the keyboard, for dialogs are not where a mouse would look for them. */
    private JFileChooserFixture save(Path file) {
        var button = (AbstractButton) robot.finder().findByName(frame, "savePicture");
        GuiActionRunner.execute(() -> EventQueue.invokeLater(button::doClick));
        JFileChooserFixture dialog = window.fileChooser("save.dialog");
        dialog.fileNameTextBox().setText(file.toString());
        dialog.fileNameTextBox().pressAndReleaseKeys(KeyEvent.VK_ENTER);
        return dialog;
    }

    private Path saved(String name) {
        Path file = folder.resolve(name);
        save(file);
        await(name, () -> Files.exists(file));
        await("where it is", () -> status().endsWith(file.toString()));
        robot.waitForIdle();
        return file;
    }

    private Collection<Component> modes() {
        return robot.finder()
                .findAll(
                        frame,
                        part ->
                                part instanceof JComboBox
                                        && "mode".equals(part.getName())
                                        && part.isShowing());
    }

    private int countOfModes() {
        return modes().isEmpty() ? 1 : window.comboBox("mode").target().getItemCount();
    }

    @ParameterizedTest(name = "a picture cannot be saved: {0}")
    @MethodSource("tabsWithPictures")
    void eachPictureIsSavedDotByDotAndAsADrawing(String tab) throws Exception {
        show(tab);
        int count = countOfModes();
        for (int mode = 0; mode < count; mode++) {
            if (count > 1) window.comboBox("mode").selectItem(mode);
            robot.waitForIdle();
            BufferedImage picture = ImageIO.read(saved(tab + mode + ".png").toFile());
            assertTrue(picture.getWidth() > 300 && picture.getHeight() > 200, picture.toString());
            Element drawing = root(saved(tab + mode + ".svg"));
            assertEquals("svg", drawing.getTagName());
            assertTrue(drawing.getElementsByTagName("g").getLength() > 1, tab + mode + " is empty");
        }
    }

    /** All but Exercises, whose pictures belong to a check. */
    static Stream<String> tabsWithPictures() {
        return LabTabs.NAMES.stream().filter(tab -> !tab.equals("exercises"));
    }

    private static Element root(Path file) throws Exception {
        var factory = DocumentBuilderFactory.newInstance();
        factory.setFeature("http://apache.org/xml/features/nonvalidating/load-external-dtd", false);
        return factory.newDocumentBuilder().parse(file.toFile()).getDocumentElement();
    }

    @Test
    void refusedNameLeavesTheDialogOpen() {
        Path file = folder.resolve("lines.jpg");
        JFileChooserFixture dialog = save(file);
        window.optionPane()
                .requireMessage(file + ": unknown extension; allowed are .png and .svg")
                .pressAndReleaseKeys(KeyEvent.VK_ENTER);
        assertFalse(Files.exists(file));
        Path other = folder.resolve("lines.svg");
        GuiActionRunner.execute(
                () -> {
                    dialog.target().setSelectedFile(other.toFile());
                    dialog.target().approveSelection();
                });
        await("the drawing", () -> Files.exists(other));
    }
}
