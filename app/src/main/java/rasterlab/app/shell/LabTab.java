package rasterlab.app.shell;

import javax.swing.JComponent;

/**
 * One tab of the window.
 *
 * @param name the same in every language, such as {@code line}; also the panel's component name
 * @param title in the window's language
 * @param mnemonic key code to press with Alt, 0 for none
 * @param mnemonicIndex where that letter is in the title, −1 for nowhere
 * @param panel the lab
 * @param focusPicture gives the keyboard to the lab's picture, whose keys change what it shows
 */
public record LabTab(
        String name,
        String title,
        int mnemonic,
        int mnemonicIndex,
        JComponent panel,
        Runnable focusPicture) {}
