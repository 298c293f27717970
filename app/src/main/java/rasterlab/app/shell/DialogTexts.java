package rasterlab.app.shell;

import javax.swing.UIManager;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The words of Swing's own dialogs, which Swing has in English and a few other languages only. */
final class DialogTexts {
    private DialogTexts() {}

    /** Makes every dialog created from now on speak the language. */
    static void install(Language language) {
        Texts texts = Texts.of("shell", "dialogs", language);
        for (String key : texts.keys()) UIManager.put(key, texts.text(key));
    }
}
