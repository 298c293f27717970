package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.shell.settings.LabTheme;

class DialogTextsTest {
    private static final Pattern ENGLISH = Pattern.compile("[A-Za-z]{2}");

    @AfterEach
    void sayNothingOfDialogs() throws Exception {
        OffscreenPainter.onEventThread(UsualLook::install);
    }

    @Test
    @DisplayName("a file dialog speaks English in the Russian window, or Russian after it")
    void fileDialogsSpeakTheLanguage() {
        LabTheme.LIGHT.install();
        DialogTexts.install(Language.RUSSIAN);
        List<String> russian = dialogTexts(JFileChooser.SAVE_DIALOG);
        assertTrue(russian.contains("Сохранить"), russian.toString());
        assertTrue(russian.contains("Имя файла:"), russian.toString());
        assertEquals(
                List.of(), russian.stream().filter(text -> ENGLISH.matcher(text).find()).toList());
        DialogTexts.install(Language.ENGLISH);
        List<String> english = dialogTexts(JFileChooser.OPEN_DIALOG);
        assertTrue(english.contains("Open"), english.toString());
        assertTrue(english.contains("File name:"), english.toString());
    }

    private static List<String> dialogTexts(int type) {
        var chooser = new JFileChooser();
        chooser.setDialogType(type);
        var texts = new ArrayList<String>();
        collect(chooser, texts);
        texts.add(chooser.getUI().getDialogTitle(chooser));
        texts.add(chooser.getAcceptAllFileFilter().getDescription());
        return texts;
    }

    private static void collect(Component part, List<String> texts) {
        if (part instanceof JLabel label) add(label.getText(), texts);
        if (part instanceof AbstractButton button) add(button.getText(), texts);
        if (part instanceof JComponent tipped) add(tipped.getToolTipText(), texts);
        if (part instanceof Container whole)
            for (Component each : whole.getComponents()) collect(each, texts);
    }

    private static void add(String text, List<String> texts) {
        if (text != null && !text.isBlank()) texts.add(text);
    }
}
