package rasterlab.app.exercise.panel;

import java.awt.Font;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.UIManager;
import rasterlab.app.canvas.method.SecondaryText;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.exercise.BackgroundWork;
import rasterlab.app.exercise.ExerciseState;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.outcome.VerdictLook;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.ScorePoints;
import rasterlab.exercises.topic.TopicGradings;

/** The head of a result: verdict, points and origin, or how far the work on it is. */
final class ResultHead extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private final JLabel verdict = new JLabel(" ");
    private final JLabel points = new JLabel(" ");
    private final JLabel where = new JLabel(" ");
    private final JProgressBar progress = new JProgressBar();
    private final JButton giveUp;

    /**
     * @param cancel gives up what runs
     */
    ResultHead(Texts texts, Runnable cancel) {
        super(FlowRows.inTheMiddle(10));
        this.texts = texts;
        verdict.setName("result.verdict");
        verdict.setFont(verdict.getFont().deriveFont(Font.BOLD));
        points.setName("result.points");
        where.setName("result.where");
        where.setForeground(SecondaryText.on(getBackground()));
        progress.setName("progress");
        progress.setStringPainted(true);
        progress.getAccessibleContext().setAccessibleName(texts.text("progress"));
        giveUp = Controls.button("cancel", texts, cancel);
        giveUp.setName("result.cancel");
        add(verdict);
        add(points);
        add(progress);
        add(giveUp);
        add(where);
        FlowRows.keepWrapped(this);
    }

    void wear(Font type) {
        List.of(points, where, giveUp).forEach(part -> part.setFont(type));
        verdict.setFont(type.deriveFont(Font.BOLD));
    }

    /** Whether something is tried or asked for. */
    boolean works() {
        return progress.isVisible();
    }

    /**
     * The button that gives up what runs, where that of the program is out of sight.
     *
     * @return whether it has gone with the keyboard
     */
    boolean offerToGiveUp(boolean alone) {
        boolean offered = works() && alone;
        if (offered == giveUp.isVisible()) return false;
        boolean hadKeyboard = giveUp.isFocusOwner();
        giveUp.setVisible(offered);
        return hadKeyboard;
    }

    /** Gives the keyboard to the button that gives up what runs, where it is in sight. */
    void focusGiveUp() {
        if (giveUp.isVisible()) giveUp.requestFocusInWindow();
    }

    /**
     * @param outcome what is shown of the cases; empty where nothing is yet
     */
    void show(ExerciseState state, Optional<Outcome> outcome) {
        show(state.work());
        if (outcome.isEmpty() || state.work().running()) {
            verdict.setText(texts.text("result." + nothingYet(state.work().phase())));
            verdict.setForeground(UIManager.getColor("Label.foreground"));
            points.setText("");
            where.setText("");
            return;
        }
        Outcome said = outcome.get();
        verdict.setText(
                VerdictLook.sign(said.verdict())
                        + " "
                        + GradingVerdict.word(said.verdict(), texts.locale().getLanguage()));
        verdict.setForeground(VerdictLook.color(said.verdict(), getBackground()));
        points.setText(points(said));
        where.setText(where(state, said));
        where.setToolTipText(said.isolation().in(texts.language()));
    }

    private void show(BackgroundWork work) {
        progress.setVisible(work.running());
        progress.setIndeterminate(work.of() == 0 || work.done() == 0);
        progress.setMaximum(Math.max(1, work.of()));
        progress.setValue(work.done());
        String phase = work.phase().name().toLowerCase(Locale.ROOT);
        if (!work.running()) return;
        progress.setString(texts.text("phase." + phase, work.done(), work.of()));
        // It asks for the room that its words need, but not for a new layout.
        progress.revalidate();
    }

    private static String nothingYet(BackgroundWork.Phase phase) {
        return switch (phase) {
            case NONE, READING -> "none";
            case JOINING -> "joining";
            case CHECKING, SENDING, WAITING, GRADING -> "running";
        };
    }

    private String points(Outcome said) {
        ScorePoints earned = said.points();
        String sum =
                texts.text(
                        "result.points",
                        said.total(),
                        earned.of(),
                        earned.accuracy(),
                        earned.stability(),
                        earned.speed());
        return said.hints() > 0 ? sum + ", " + texts.text("result.hints", said.hints()) : sum;
    }

    private String where(ExerciseState state, Outcome said) {
        String place =
                said.attempt() == 0
                        ? texts.text("result.here", said.isolation().in(texts.language()))
                        : texts.text("result.attempt", said.attempt());
        String nanos = String.format(texts.locale(), "%.2f", said.nanosPerItem());
        String cost =
                said.nanosPerItem() > 0 ? ", " + texts.text(costKey(state.exercise()), nanos) : "";
        String earlier = said.earlier() ? ", " + texts.text("result.earlier") : "";
        return place + cost + earlier + (state.upToDate() ? "" : ", " + texts.text("result.old"));
    }

    private static String costKey(Exercise exercise) {
        return TopicGradings.named(exercise.topic()).inOwnWords("result.cost");
    }
}
