package rasterlab.app.exercise.panel;

import java.awt.Insets;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import rasterlab.app.language.Texts;

/** Buttons and labels of the tab, named after the keys of their texts. */
final class Controls {
    /** A margin narrower than usual, so that a row of buttons fits beside the statement. */
    private static final Insets MARGIN = new Insets(2, 10, 2, 10);

    private Controls() {}

    /**
     * A button with its mnemonic and, where there are such, its hint {@code KEY.hint} and its name
     * {@code KEY.name} for those who hear it.
     */
    static JButton button(String key, Texts texts, Runnable action) {
        var button = new JButton(texts.label(key));
        button.setName(key);
        if (texts.mnemonic(key) != 0) {
            button.setMnemonic(texts.mnemonic(key));
            button.setDisplayedMnemonicIndex(texts.mnemonicIndex(key));
        }
        if (texts.has(key + ".hint")) button.setToolTipText(texts.text(key + ".hint"));
        if (texts.has(key + ".name"))
            button.getAccessibleContext().setAccessibleName(texts.text(key + ".name"));
        button.setMargin(MARGIN);
        button.putClientProperty("FlatLaf.style", "minimumWidth: 0");
        button.addActionListener(e -> action.run());
        return button;
    }

    /** The label of a control, to which its mnemonic goes. */
    static JLabel label(String key, Texts texts, JComponent control) {
        var label = new JLabel(texts.label(key));
        label.setName(key + ".label");
        label.setLabelFor(control);
        control.getAccessibleContext().setAccessibleName(texts.label(key));
        if (texts.mnemonic(key) != 0) {
            label.setDisplayedMnemonic(texts.mnemonic(key));
            label.setDisplayedMnemonicIndex(texts.mnemonicIndex(key));
        }
        return label;
    }

    /** Words that wrap and can be selected, but not changed. */
    static JTextArea words(String name) {
        var words = new JTextArea();
        words.setName(name);
        words.setEditable(false);
        words.setOpaque(false);
        words.setLineWrap(true);
        words.setWrapStyleWord(true);
        words.setFont(UIManager.getFont("Label.font"));
        // The foot of a J begins left of its place.
        words.setBorder(BorderFactory.createEmptyBorder(0, 2, 0, 0));
        return words;
    }
}
