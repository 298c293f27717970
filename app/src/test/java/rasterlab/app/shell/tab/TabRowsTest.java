package rasterlab.app.shell.tab;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.DefaultKeyboardFocusManager;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.function.Predicate;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.shell.settings.LabTheme;

class TabRowsTest {
    /**
     * Says that no window is active, for a pane in no window, whichever window other tests have
     * left active.
     */
    private static final class NoWindowActive extends DefaultKeyboardFocusManager {
        @Override
        public Window getActiveWindow() {
            return null;
        }
    }

    private KeyboardFocusManager before;

    @BeforeEach
    void haveNoWindow() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    before = KeyboardFocusManager.getCurrentKeyboardFocusManager();
                    KeyboardFocusManager.setCurrentKeyboardFocusManager(new NoWindowActive());
                });
    }

    @AfterEach
    void useLight() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    KeyboardFocusManager.setCurrentKeyboardFocusManager(before);
                    LabTheme.LIGHT.install();
                });
    }

    @ParameterizedTest(name = "titles in rows look the same with and without the keyboard: {0}")
    @EnumSource
    void chosenTitleShowsThatItHasTheKeyboard(LabTheme theme) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    theme.install();
                    var pane = new JTabbedPane();
                    pane.setUI(new TabRows());
                    for (String title : new String[] {"coordinates", "lines", "polygons", "light"})
                        pane.addTab(title, new JPanel());
                    pane.setSize(200, 150);
                    pane.doLayout();
                    assertTrue(pane.getTabRunCount() > 1);
                    Rectangle chosen = pane.getBoundsAt(0);
                    assertFalse(
                            Arrays.equals(title(pane, chosen, false), title(pane, chosen, true)));
                });
    }

    private static int[] title(JTabbedPane pane, Rectangle place, boolean keyboard) {
        Predicate<JComponent> owner = component -> keyboard;
        pane.putClientProperty(FlatClientProperties.COMPONENT_FOCUS_OWNER, owner);
        var image = new BufferedImage(200, 150, BufferedImage.TYPE_INT_RGB);
        pane.paint(image.createGraphics());
        return image.getRGB(place.x, place.y, place.width, place.height, null, 0, place.width);
    }
}
