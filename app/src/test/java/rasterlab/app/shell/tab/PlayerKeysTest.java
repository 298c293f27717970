package rasterlab.app.shell.tab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.Component;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class PlayerKeysTest {
    private static final KeyStroke SPACE = KeyStroke.getKeyStroke("SPACE");
    private static final KeyStroke HOME = KeyStroke.getKeyStroke("HOME");

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("controls")
    void keysGoToThePlayerUnlessAControlNeedsThem(
            boolean taken, KeyStroke key, Component focus, boolean byTab) {
        assertEquals(taken, PlayerKeys.isTaken(key, focus, byTab));
    }

    static Stream<Arguments> controls() {
        var text = new JTextArea("about");
        text.setEditable(false);
        return Stream.of(
                argumentSet("space is lost on a clicked chip", false, SPACE, new JButton(), false),
                argumentSet("Home is lost on a clicked list", false, HOME, list(), false),
                argumentSet("Home is lost on a dragged slider", false, HOME, new JSlider(), false),
                argumentSet("Home scrolls a text that cannot change", false, HOME, text, false),
                argumentSet("Home leaves a text field", true, HOME, new JTextField(), false),
                argumentSet("space leaves a text field", true, SPACE, new JTextField(), true),
                argumentSet("Tab and space press no button", true, SPACE, new JButton(), true),
                argumentSet("Tab and space tick no box", true, SPACE, new JCheckBox(), true),
                argumentSet("Tab and Home move no slider", true, HOME, new JSlider(), true),
                argumentSet("Home is lost on a handle", false, HOME, new JLabel(), true));
    }

    private static JComboBox<String> list() {
        return new JComboBox<>(new String[] {"one", "two"});
    }
}
