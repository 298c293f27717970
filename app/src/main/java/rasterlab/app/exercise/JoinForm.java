package rasterlab.app.exercise;

import java.awt.Component;
import java.util.Optional;
import javax.swing.JCheckBox;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JPasswordField;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Texts;

/** Asks for a server and a course on it, or for a token that the student has already. */
final class JoinForm extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private final JTextField address = new JTextField(24);
    private final JTextField code = new JTextField(24);
    private final JTextField student = new JTextField(24);
    private final JCheckBox known;
    private final JPasswordField token = new JPasswordField(24);

    JoinForm(Texts texts, Optional<Account> account) {
        super(new MigLayout("insets 0, gap 8 8, wrap 2", "[][grow,fill]"));
        this.texts = texts;
        known = new JCheckBox(texts.label("join.known"));
        known.setName("join.known");
        known.setMnemonic(texts.mnemonic("join.known"));
        known.setDisplayedMnemonicIndex(texts.mnemonicIndex("join.known"));
        address.setText(account.map(Account::toString).orElse("http://localhost:8080"));
        row("join.address", address);
        row("join.code", code);
        row("join.name", student);
        add(known, "span 2");
        row("join.token", token);
        known.addActionListener(e -> enableFields());
        enableFields();
    }

    private void row(String key, JTextField field) {
        field.setName(key);
        add(Controls.label(key, texts, field));
        add(field);
    }

    private void enableFields() {
        code.setEnabled(!known.isSelected());
        student.setEnabled(!known.isSelected());
        token.setEnabled(known.isSelected());
    }

    /** Shows the form until it is answered; the model is told a whole answer. */
    void ask(Component parent, ExerciseLabModel model) {
        String[] answers = {texts.text("join.ok"), texts.text("join.cancel")};
        int answer =
                JOptionPane.showOptionDialog(
                        parent,
                        this,
                        texts.text("join.title"),
                        JOptionPane.OK_CANCEL_OPTION,
                        JOptionPane.PLAIN_MESSAGE,
                        null,
                        answers,
                        answers[0]);
        if (answer != JOptionPane.OK_OPTION) return;
        if (known.isSelected())
            model.signIn(address.getText(), String.valueOf(token.getPassword()));
        else model.join(address.getText(), code.getText().strip(), student.getText().strip());
    }
}
