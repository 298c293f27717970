package rasterlab.app.shell;

import java.awt.Component;
import java.awt.Font;
import java.io.PrintWriter;
import java.io.StringWriter;
import javax.swing.JButton;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.file.Copying;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Texts;

/** Says in one sentence what failed and keeps the details ready to be copied. */
final class ErrorDialog {
    private final Texts texts;

    ErrorDialog(Texts texts) {
        this.texts = texts;
    }

    /** Shows the failure and waits until it is closed. On the event thread. */
    void show(Component parent, Throwable failure) {
        JOptionPane.showMessageDialog(
                parent, content(failure), texts.text("error.title"), JOptionPane.ERROR_MESSAGE);
    }

    JPanel content(Throwable failure) {
        String details = details(failure);
        var area = new JTextArea(details, 10, 60);
        area.setName("error.details");
        area.setEditable(false);
        area.setFont(
                new Font(Font.MONOSPACED, Font.PLAIN, UIManager.getFont("Label.font").getSize()));
        area.setCaretPosition(0);
        area.getAccessibleContext().setAccessibleName(texts.text("error.details"));

        var copy = new JButton(texts.label("error.copy"));
        copy.setName("error.copy");
        copy.setMnemonic(texts.mnemonic("error.copy"));
        copy.setDisplayedMnemonicIndex(texts.mnemonicIndex("error.copy"));
        Runnable copied = () -> copy.setText(texts.text("error.copied"));
        copy.addActionListener(
                e -> Copying.toSystem().text(details, copied, refused -> area.selectAll()));

        var panel = new JPanel(new MigLayout("insets 0, wrap 1, gap 8", "[grow,fill]"));
        var sentence = new WrappedText("error.sentence");
        sentence.show(sentence(failure));
        panel.add(sentence, "wmin 0");
        panel.add(new JScrollPane(area), "hmin 120");
        panel.add(copy, "growx 0");
        return panel;
    }

    private String sentence(Throwable failure) {
        String message = failure.getMessage();
        String reason = message == null || message.isBlank() ? failure.toString() : message;
        return texts.text(
                "error.sentence",
                Complaints.translated(texts.language(), reason.lines().findFirst().orElse(reason)));
    }

    private static String details(Throwable failure) {
        var trace = new StringWriter();
        failure.printStackTrace(new PrintWriter(trace));
        return "Rasterlab, Java "
                + System.getProperty("java.version")
                + ", "
                + System.getProperty("os.name")
                + "\n"
                + trace;
    }
}
