package rasterlab.app.practice;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Font;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.lab.HasHelp;
import rasterlab.app.canvas.lab.LabLayout;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.canvas.work.Settling;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.practice.Sketch.Walked;
import rasterlab.exercises.predicting.Question;
import rasterlab.exercises.predicting.Sheet;
import rasterlab.exercises.predicting.StepText;

/** The mode "which is next?" as its lab shows it, in one language. */
final class PracticePanel extends JPanel implements Settling, HasHelp {
    private static final long serialVersionUID = 1L;

    private final transient PracticeModel model;
    private final transient Texts texts;
    private final JLabel title = new JLabel(" ");
    private final JLabel position = new JLabel(" ");
    private final WrappedText question = new WrappedText("practice.question");
    private final WrappedText told = new WrappedText("practice.told");
    private final WrappedText hint = new WrappedText("practice.hint");
    private final JLabel score = new JLabel(" ");
    private final SeedField seed;
    private final JButton answer;
    private final JButton next;
    private final JButton leave;
    private final JPanel practised =
            new JPanel(new MigLayout("insets 0, gap 8 8", "[grow,fill][]", ""));
    private final JPanel graded =
            new JPanel(new MigLayout("insets 0, gap 8 8", "[grow,fill][grow,fill]", ""));

    /** Whether the sheet's open steps were told since the state changed last. */
    private boolean warned;

    private final AnswerForm form;
    private final VerdictPane verdict;
    private final PracticeStage stage;
    private final JPanel place = new JPanel(new BorderLayout());
    private final JTextArea walk = new JTextArea();
    private final JScrollPane walkScroll = new JScrollPane(walk);
    private final JPanel column;
    private transient Optional<Question> shown = Optional.empty();

    PracticePanel(PracticeModel model, Language language) {
        super(new MigLayout("insets 8 10 10 10, gap 10 8", "[grow,fill][fill]", "[][grow,fill]"));
        this.model = model;
        texts = Texts.of("practice", language);
        setName("practice");
        answer = button("answer", this::submit);
        next = button("next", this::next);
        leave = button("leave", model::leave);
        form = new AnswerForm(texts, this::submit);
        verdict = new VerdictPane(texts);
        stage = new PracticeStage(texts, this::picked);
        title.setName("practice.title");
        title.putClientProperty("FlatLaf.styleClass", "h3");
        position.setName("practice.position");
        question.setFont(question.getFont().deriveFont(Font.BOLD));
        score.setName("practice.score");
        score.setFont(score.getFont().deriveFont(Font.BOLD));
        walk.setName("practice.walk");
        walk.setEditable(false);
        walk.setLineWrap(true);
        walk.setWrapStyleWord(true);
        walk.getAccessibleContext().setAccessibleName(texts.text("walk"));
        seed = new SeedField(texts, model::dataOf, () -> refuse(Optional.empty()));
        column = column();
        add(title, "wmin 0");
        add(leave, "growx, wrap");
        add(place, "wmin 100, hmin 100");
        add(column, "w %d!".formatted(UIScale.scale(LabLayout.INSPECTOR)));
        bindKeys();
    }

    private JPanel column() {
        var parts =
                new JPanel(
                        new MigLayout("insets 0, gap 0 8, wrap 1, hidemode 3", "[grow,fill]", ""));
        parts.add(position, "wmin 0");
        parts.add(question, "wmin 0");
        parts.add(told, "wmin 0");
        parts.add(hint, "wmin 0");
        parts.add(form, "wmin 0");
        parts.add(answer);
        parts.add(next);
        parts.add(verdict, "wmin 0, gaptop 6");
        parts.add(score, "wmin 0");
        practised.add(seed, "wmin 0");
        practised.add(button("newData", model::newData));
        parts.add(practised);
        graded.add(button("before", () -> model.turn(-1)));
        graded.add(button("after", () -> model.turn(1)), "wrap");
        graded.add(button("handIn", this::handIn), "span 2");
        parts.add(graded);
        return parts;
    }

    private JButton button(String key, Runnable action) {
        var button = new JButton(texts.label(key));
        button.setName("practice." + key);
        button.setMnemonic(texts.mnemonic(key));
        button.setDisplayedMnemonicIndex(texts.mnemonicIndex(key));
        button.addActionListener(e -> action.run());
        return button;
    }

    private void bindKeys() {
        KeyBinding.within(this, KeyStroke.getKeyStroke("ESCAPE"), model::leave);
        KeyBinding.within(this, KeyStroke.getKeyStroke("ENTER"), this::submit);
        for (int digit = 0; digit <= 9; digit++) {
            int pressed = digit;
            // Bound as a character, not as a key: a text field uses the keys itself.
            KeyStroke key = KeyStroke.getKeyStroke("typed " + digit);
            KeyBinding.within(this, key, () -> form.digit(pressed));
            // Nobody writes into this text, which would hear the key first.
            KeyBinding.whenFocused(walk, key, () -> form.digit(pressed));
        }
        for (String key : List.of("typed +", "typed ="))
            KeyBinding.within(this, KeyStroke.getKeyStroke(key), () -> stage.zoom(1));
        KeyBinding.within(this, KeyStroke.getKeyStroke("typed -"), () -> stage.zoom(-1));
        // The stage takes 0 for a wish to see everything, which it is where it is no answer.
        KeyBinding.within(
                stage,
                KeyStroke.getKeyStroke("typed 0"),
                () -> {
                    if (!form.digit(0)) stage.fit();
                });
    }

    @Override
    public void settle() throws InterruptedException {
        model.settle();
    }

    @Override
    public String helpKey() {
        return PracticeCards.HELP;
    }

    /** Gives the keyboard to the picture where pixels are asked for, else to the answer. */
    void focusPicture() {
        PracticeState state = model.state();
        if (state.resting()) next.requestFocusInWindow();
        else if (stage.isShowing() && stage.takesKeys()) stage.requestFocusInWindow();
        else form.focus();
    }

    private void picked(StagePick pick) {
        form.set(pick.answer());
        if (pick.tolerance() > 0 && model.state().graded().isPresent()) {
            // A hand is not exact enough for what is paid for: the numbers can be mended.
            form.focus();
            return;
        }
        if (form.missing().isEmpty() && !pick.answer().isEmpty())
            model.answer(form.answer(), pick.tolerance());
        else submitUnlessPart(pick);
    }

    /** A part of an answer waits for the rest; a key in the picture confirms. */
    private void submitUnlessPart(StagePick pick) {
        if (pick.answer().isEmpty()) submit();
        else form.focus();
    }

    private void submit() {
        PracticeState state = model.state();
        if (state.resting()) {
            next();
            return;
        }
        if (!state.isAsking()) return;
        Optional<String> missing = form.missing();
        if (missing.isEmpty()) {
            model.answer(form.answer(), 0);
            return;
        }
        refuse(missing);
        form.focus();
    }

    /**
     * Says what is wrong with what was typed, also in another language.
     *
     * @param missing the field that has no value; empty for a seed that is none
     */
    private void refuse(Optional<String> missing) {
        model.refuse(new InvalidEntry(missing, form.answer()));
        tellRefusal();
    }

    private void tellRefusal() {
        model.refusal().map(this::refusalText).ifPresent(verdict::tell);
    }

    private String refusalText(InvalidEntry refusal) {
        String topic = model.state().topic().orElseThrow();
        return refusal.missing()
                .map(field -> texts.text("missing", words(topic).label(field)))
                .orElseGet(() -> texts.text("seed.wrong", String.valueOf(Sheet.MOST_SEED)));
    }

    private StepText words(String topic) {
        return new StepText(topic, texts.locale());
    }

    /** Asks once more where steps have no answer yet. */
    private void handIn() {
        PracticeState state = model.state();
        PracticeSheet sheet = state.asked().orElseThrow();
        int open = sheet.size() - state.graded().orElseThrow().given(sheet);
        if (open == 0 || warned) {
            model.handIn();
            return;
        }
        warned = true;
        verdict.tell(texts.text("handIn.open", open));
    }

    private void next() {
        model.next();
        focusPicture();
    }

    /** Shows the model's present state. */
    void refresh() {
        warned = false;
        PracticeState state = model.state();
        boolean handed = state.graded().isPresent();
        score.setText(
                state.graded()
                        .map(
                                answers -> {
                                    PracticeSheet sheet = state.asked().orElseThrow();
                                    return texts.text("given", answers.given(sheet), sheet.size());
                                })
                        .orElseGet(() -> texts.text("score", state.right(), state.given())));
        practised.setVisible(!handed);
        graded.setVisible(handed);
        leave.setText(texts.label(handed ? "back" : "leave"));
        seed.show(state.seed());
        boolean ready = state.asked().isPresent();
        if (ready) refresh(state);
        else {
            position.setText(texts.text("drawing"));
            shown = Optional.empty();
        }
        column.revalidate();
    }

    private void refresh(PracticeState state) {
        String language = texts.locale().getLanguage();
        PracticeSheet sheet = state.asked().orElseThrow();
        Question now = state.question();
        String topic = state.topic().orElseThrow();
        title.setText(sheet.exercise().title().get(language));
        position.setText(texts.text("position", state.at() + 1, sheet.size()));
        question.show(now.rules().question(language));
        told.show(texts.text("told", words(topic).fieldsText(now.givenFields())));
        told.setVisible(state.isAsking() && !now.givenFields().isEmpty());
        Optional<Sketch> sketch = Sketches.of(topic);
        Optional<Board> board = sketch.map(each -> each.of(walked(state)));
        boolean other = shown.filter(now::equals).isEmpty();
        if (other) form.show(topic, now, board);
        if (other) model.refusal().map(InvalidEntry::typed).ifPresent(form::set);
        place(board.isPresent());
        board.ifPresent(drawn -> stage.show(drawn, isOtherWalk(now), state.isAsking()));
        hint.show(hint(board, state.graded().isPresent()));
        hint.setVisible(state.isAsking() && !hint.getText().isEmpty());
        form.showAsking(state.isAsking());
        answer.setVisible(state.isAsking());
        next.setVisible(state.resting() && (state.graded().isEmpty() || !state.isThrough()));
        next.setText(texts.label(state.isThrough() ? "again" : "next"));
        verdict.setVisible(state.last().isPresent());
        state.last().ifPresent(last -> verdict.show(last, topic));
        tellRefusal();
        walk.setText(WalkText.of(state, texts));
        walk.setCaretPosition(0);
        shown = Optional.of(now);
        if (other || state.resting()) focusPicture();
    }

    private boolean isOtherWalk(Question now) {
        return shown.filter(before -> before.input().equals(now.input())).isEmpty();
    }

    private static Walked walked(PracticeState state) {
        return new Walked(
                WalkText.input(state.question().input()),
                state.steps(),
                state.givenFields(),
                state.wrong());
    }

    /** The meaning of a click in the picture, in words. */
    private String hint(Optional<Board> board, boolean graded) {
        return board.map(each -> each.picking().getClass().getSimpleName())
                .map(pick -> "hint." + pick.replace("Pick", "").toLowerCase())
                .map(key -> graded && texts.has(key + ".graded") ? key + ".graded" : key)
                .map(key -> texts.textOr(key, ""))
                .orElse("");
    }

    /** Places the picture beside the column; where there is none, the words take its place. */
    private void place(boolean drawn) {
        JComponent wanted = drawn ? stage : walkScroll;
        if (place.getComponentCount() > 0 && place.getComponent(0) == wanted) return;
        place.removeAll();
        place.add(wanted);
        float size = title.getFont().getSize2D();
        if (drawn) size = question.getFont().getSize2D();
        walk.setFont(new Font(Font.MONOSPACED, Font.PLAIN, 1).deriveFont(size));
        if (drawn) column.add(walkScroll, "wmin 0, hmin 60, growy, pushy");
        revalidate();
    }
}
