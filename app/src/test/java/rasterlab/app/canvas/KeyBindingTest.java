package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class KeyBindingTest {
    private static final int CTRL = InputEvent.CTRL_DOWN_MASK;
    private static final int SHIFT = InputEvent.SHIFT_DOWN_MASK;
    private static final int ALT_GR = CTRL | InputEvent.ALT_DOWN_MASK;

    private static final class Stage extends JPanel {
        private static final long serialVersionUID = 1L;

        void type(char key, int modifiers) {
            var event =
                    new KeyEvent(
                            this, KeyEvent.KEY_TYPED, 0, modifiers, KeyEvent.VK_UNDEFINED, key);
            processKeyBinding(KeyStroke.getKeyStroke(key), event, WHEN_FOCUSED, false);
        }
    }

    @ParameterizedTest(name = "a key of the window with Ctrl is one of the picture too: {0}")
    @CsvSource({"plain, 0, 1", "Ctrl, " + CTRL + ", 0", "Shift, " + SHIFT + ", 1"})
    void typedKeysAreTakenWithoutControl(String name, int modifiers, int times) {
        assertEquals(times, actions(modifiers));
    }

    @ParameterizedTest(name = "a key that needs {0} on some keyboards is not taken")
    @CsvSource("AltGr, " + ALT_GR)
    void typedKeysAreTakenWithAltGr(String name, int modifiers) {
        assertEquals(1, actions(modifiers));
    }

    private static int actions(int modifiers) {
        var done = new AtomicInteger();
        var stage = new Stage();
        KeyBinding.whenFocused(stage, KeyStroke.getKeyStroke("typed ="), done::incrementAndGet);
        stage.type('=', modifiers);
        return done.get();
    }
}
