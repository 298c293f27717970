package rasterlab.app.exercise.panel;

import java.awt.Color;
import java.awt.Component;
import java.awt.EventQueue;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JPasswordField;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.exercise.ExerciseLabModel;
import rasterlab.app.exercise.ExerciseState;
import rasterlab.app.exercise.JoinAnswer;
import rasterlab.app.exercise.outcome.VerdictLook;
import rasterlab.app.language.Texts;
import rasterlab.app.server.Account;

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
    private final JTextArea problem = words("join.problem");
    private final Map<JTextField, JLabel> labels = new HashMap<>();

    /** Whether a server is asked, so that nothing can be typed. */
    private transient BooleanSupplier joining = () -> false;

    /**
     * The text that a later form begins with, for the server may refuse it. A token is typed anew.
     */
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
    private record Change(Runnable listener) implements DocumentListener {
        @Override
        public void insertUpdate(DocumentEvent e) {
            listener.run();
        }

        @Override
        public void removeUpdate(DocumentEvent e) {
            listener.run();
        }

        @Override
        public void changedUpdate(DocumentEvent e) {
            listener.run();
        }
    }

    /**
     * @param joined where the student is already
     */
    JoinForm(Texts texts, Optional<Account> joined, Typed before) {
        super(new MigLayout("insets 0, gap 8 8, wrap 2", "[][grow,fill]"));
        this.texts = texts;
        join = new JButton(texts.text("join.ok"));
        join.setName("join.ok");
        cancel = new JButton(texts.text("join.cancel"));
        cancel.setName("join.cancel");
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
        joined.ifPresent(account -> add(accountText(account, width), "span 2, growx, wmin 0", 0));
        known.addActionListener(e -> enableFields());
        enableFields();
    }

    /**
     * @param width of the form, in which the words wrap: what they need is known before it is shown
     */
    private JTextArea accountText(Account account, int width) {
        JTextArea words = words("join.joined");
        String key = account.student().isEmpty() ? "join.joined" : "join.joinedAs";
        words.setText(texts.text(key, account.toString(), account.student()));
        words.setSize(width, Short.MAX_VALUE);
        words.getAccessibleContext().setAccessibleName(texts.text("join.title"));
        return words;
    }

    /** Tab goes from field to field. */
    private static JTextArea words(String name) {
        JTextArea words = Controls.words(name);
        words.setFocusable(false);
        return words;
    }

    private void row(String key, JTextField field) {
        field.setName(key);
        field.getDocument().addDocumentListener(new Change(this::enableFields));
        JLabel label = Controls.label(key, texts, field);
        labels.put(field, label);
        add(label);
        add(field);
    }

    private void enableFields() {
        known.setEnabled(!joining.getAsBoolean());
        enable(address, true);
        enable(code, !known.isSelected());
        enable(student, !known.isSelected());
        enable(token, known.isSelected());
        join.setEnabled(!joining.getAsBoolean() && needed().noneMatch(JoinForm::isEmpty));
    }

    private void enable(JTextField field, boolean needed) {
        boolean typedIn = needed && !joining.getAsBoolean();
        field.setEnabled(typedIn);
        if (!typedIn) field.getCaret().setVisible(false);
        labels.get(field).setEnabled(needed);
    }

    /** The fields that are needed, in their order in the form. */
    private Stream<JTextField> needed() {
        return known.isSelected() ? Stream.of(address, token) : Stream.of(address, code, student);
    }

    private static boolean isEmpty(JTextField field) {
        return field.getDocument().getLength() == 0 || field.getText().isBlank();
    }

    Typed typed() {
        return new Typed(address.getText(), code.getText(), student.getText());
    }

    /** Shows the form until a course is joined or the form is given up. */
    void ask(Component parent, ExerciseLabModel model) {
        var question = new Question();
        join.addActionListener(e -> join(model));
        cancel.addActionListener(e -> question.setValue(cancel));
        model.enrolment().askForCourse();
        joining = () -> model.state().joins();
        Runnable end = model.listen(state -> follow(state, question));
        JDialog dialog =
                question.createDialog(SwingUtilities.getRoot(parent), texts.text("join.title"));
        dialog.setVisible(true);
        end.run();
        dialog.dispose();
        if (model.state().joins()) model.cancel();
    }

    private void join(ExerciseLabModel model) {
        forget();
        if (known.isSelected())
            model.enrolment().signIn(address.getText(), String.valueOf(token.getPassword()));
        else
            model.enrolment()
                    .join(address.getText(), code.getText().strip(), student.getText().strip());
    }

    private void follow(ExerciseState state, Question question) {
        JoinAnswer answer = state.joining();
        if (state.joins()) {
            cancel.requestFocusInWindow();
            tell(address, texts.text("notice.joining"), UIManager.getColor("Label.foreground"));
        }
        enableFields();
        if (answer.joined()) question.setValue(join);
        else if (!answer.problem().isEmpty() && !tells(answer)) tell(answer);
        else if (answer.problem().isEmpty() && !state.joins()) forget();
    }

    private void forget() {
        remove(problem);
        revalidate();
        repaint();
    }

    /** Whether that is said already, so that no other news takes the keyboard from its place. */
    private boolean tells(JoinAnswer refused) {
        return problem.getParent() == this && problem.getText().equals(refused.problem().in(texts));
    }

    /** Shows a refusal below the field that is to be typed anew, which gets the keyboard. */
    private void tell(JoinAnswer refused) {
        JTextField field =
                switch (refused.field()) {
                    case ADDRESS -> address;
                    case CODE -> code;
                    case NAME -> student;
                    case TOKEN -> token;
                };
        tell(field, refused.problem().in(texts), VerdictLook.color("wrong", getBackground()));
        EventQueue.invokeLater(field::requestFocusInWindow);
    }

    private void tell(JTextField field, String said, Color color) {
        problem.setText(said);
        problem.setForeground(color);
        problem.setSize(address.getWidth(), Short.MAX_VALUE);
        remove(problem);
        add(problem, "skip, growx, wmin 0", List.of(getComponents()).indexOf(field) + 1);
        SwingUtilities.getWindowAncestor(this).pack();
    }
}
