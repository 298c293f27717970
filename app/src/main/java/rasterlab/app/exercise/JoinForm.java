package rasterlab.app.exercise;

import java.awt.Component;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JDialog;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JPasswordField;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
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
    private final JButton join;
    private final JButton cancel;

    /** What a later form begins with, for the server may refuse it. A token is typed anew. */
    record Typed(String address, String code, String student) {
        static Typed first(Optional<Account> account) {
            return new Typed(
                    account.map(Account::toString).orElse("http://localhost:8080"), "", "");
        }
    }

    /** The answers below the form; the first empty field is what is typed in. */
    private final class Question extends JOptionPane {
        private static final long serialVersionUID = 1L;

        Question() {
            super(
                    JoinForm.this,
                    PLAIN_MESSAGE,
                    OK_CANCEL_OPTION,
                    null,
                    new Object[] {join, cancel},
                    join);
        }

        @Override
        public void selectInitialValue() {
            super.selectInitialValue();
            needed().filter(JoinForm::isEmpty).findFirst().orElse(address).requestFocusInWindow();
        }
    }

    /** Tells of any change of a field. */
    private record Change(Runnable told) implements DocumentListener {
        @Override
        public void insertUpdate(DocumentEvent e) {
            told.run();
        }

        @Override
        public void removeUpdate(DocumentEvent e) {
            told.run();
        }

        @Override
        public void changedUpdate(DocumentEvent e) {
            told.run();
        }
    }

    /**
     * @param joined where the student is already
     */
    JoinForm(Texts texts, Optional<Account> joined, Typed before) {
        super(new MigLayout("insets 0, gap 8 8, wrap 2", "[][grow,fill]"));
        this.texts = texts;
        join = button("join.ok");
        cancel = button("join.cancel");
        known = new JCheckBox(texts.label("join.known"));
        known.setName("join.known");
        known.setMnemonic(texts.mnemonic("join.known"));
        known.setDisplayedMnemonicIndex(texts.mnemonicIndex("join.known"));
        address.setText(before.address());
        code.setText(before.code());
        student.setText(before.student());
        row("join.address", address);
        row("join.code", code);
        row("join.name", student);
        add(known, "span 2");
        row("join.token", token);
        int width = getPreferredSize().width;
        joined.ifPresent(account -> add(said(account, width), "span 2, growx, wmin 0", 0));
        known.addActionListener(e -> enableFields());
        enableFields();
    }

    /**
     * @param width of the form, in which the words wrap: what they need is known before it is shown
     */
    private JTextArea said(Account account, int width) {
        JTextArea words = Controls.words("join.joined");
        String key = account.student().isEmpty() ? "join.joined" : "join.joinedAs";
        words.setText(texts.text(key, account.toString(), account.student()));
        words.setSize(width, Short.MAX_VALUE);
        words.getAccessibleContext().setAccessibleName(texts.text("join.title"));
        return words;
    }

    private JButton button(String key) {
        var button = new JButton(texts.text(key));
        button.setName(key);
        button.addActionListener(
                e ->
                        ((JOptionPane) SwingUtilities.getAncestorOfClass(JOptionPane.class, button))
                                .setValue(button));
        return button;
    }

    private void row(String key, JTextField field) {
        field.setName(key);
        field.getDocument().addDocumentListener(new Change(this::enableFields));
        add(Controls.label(key, texts, field));
        add(field);
    }

    private void enableFields() {
        code.setEnabled(!known.isSelected());
        student.setEnabled(!known.isSelected());
        token.setEnabled(known.isSelected());
        join.setEnabled(needed().noneMatch(JoinForm::isEmpty));
    }

    /** In their order in the form. */
    private Stream<JTextField> needed() {
        return known.isSelected() ? Stream.of(address, token) : Stream.of(address, code, student);
    }

    private static boolean isEmpty(JTextField field) {
        return field.getDocument().getLength() == 0 || field.getText().isBlank();
    }

    Typed typed() {
        return new Typed(address.getText(), code.getText(), student.getText());
    }

    /** Shows the form until it is answered; the model is told a whole answer. */
    void ask(Component parent, ExerciseLabModel model) {
        var question = new Question();
        JDialog dialog =
                question.createDialog(SwingUtilities.getRoot(parent), texts.text("join.title"));
        dialog.setVisible(true);
        dialog.dispose();
        if (question.getValue() != join) return;
        if (known.isSelected())
            model.signIn(address.getText(), String.valueOf(token.getPassword()));
        else model.join(address.getText(), code.getText().strip(), student.getText().strip());
    }
}
