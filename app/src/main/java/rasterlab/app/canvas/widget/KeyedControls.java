package rasterlab.app.canvas.widget;

import java.util.function.Consumer;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import rasterlab.app.language.Texts;

/**
 * Makes buttons and check boxes that are named by a key of the texts, where their label with its
 * mnemonic stands, and behind {@code KEY.hint} their hint, if they have one.
 */
public final class KeyedControls {
    private KeyedControls() {}

    /** A button that is not placed yet. */
    public static JButton button(String key, Texts texts, Runnable action) {
        var button = named(new JButton(texts.label(key)), key, texts);
        button.addActionListener(e -> action.run());
        return button;
    }

    /**
     * A check box that is not placed yet.
     *
     * @param chosen told whether it is checked when the user has changed that
     */
    public static JCheckBox box(String key, Texts texts, Consumer<Boolean> chosen) {
        var box = named(new JCheckBox(texts.label(key)), key, texts);
        box.addActionListener(e -> chosen.accept(box.isSelected()));
        return box;
    }

    private static <B extends AbstractButton> B named(B button, String key, Texts texts) {
        button.setName(key);
        button.setMnemonic(texts.mnemonic(key));
        button.setDisplayedMnemonicIndex(texts.mnemonicIndex(key));
        if (texts.has(key + ".hint")) button.setToolTipText(texts.text(key + ".hint"));
        return button;
    }
}
