package rasterlab.app.exercise;

import java.awt.Component;
import java.awt.Container;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.UIManager;
import rasterlab.app.canvas.lab.NotShown;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.panel.ResultPane;
import rasterlab.app.exercise.panel.SavedExercisePanes;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.engine.raster.Plotted;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.predicting.HandedAnswers;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.ScorePoints;

/** The place of the first exercise's result without a window. On the event thread. */
public final class ShownResult {
    /** Opens nothing. */
    static final OpenInLab NOWHERE =
            new OpenInLab() {
                @Override
                public Optional<NotShown> obstacleTo(String topic, String hazard) {
                    return Optional.empty();
                }

                @Override
                public boolean handsIn(String topic) {
                    return false;
                }

                @Override
                public boolean asksSteps(String topic) {
                    return false;
                }

                @Override
                public void answerSteps(String exercise, HandedAnswers begun) {}

                @Override
                public void showToHandIn(String exercise, String topic, String json) {}

                @Override
                public Optional<NotShown> obstacleToOwn(String topic) {
                    return Optional.of(NotShown.NO_OWN);
                }

                @Override
                public void showOwn(String topic, String json, String beside) {}

                @Override
                public Optional<NotShown> obstacleToInputs(String topic) {
                    return Optional.empty();
                }

                @Override
                public void showHazard(String topic, String hazard, String method) {}

                @Override
                public void showInput(
                        String topic, String json, String method, Optional<Plotted> drawn) {}
            };

    public static final Exercise EXERCISE = Catalogue.builtIn().all().get(0);

    private ShownResult() {}

    /**
     * @param type in pixels; a machine without a display has smaller type than a desktop
     */
    public static void install(LabTheme theme, double type) {
        theme.install();
        double usual = UIManager.getFont("defaultFont").getSize2D();
        theme.install((int) Math.round(100 * type / usual));
    }

    public static ResultPane pane(Language language, Consumer<Throwable> onFailure) {
        return pane(language, new SavedExercisePanes(), onFailure);
    }

    /**
     * @param kept of the panes of one window
     */
    static ResultPane pane(
            Language language, SavedExercisePanes kept, Consumer<Throwable> onFailure) {
        return new ResultPane(
                Texts.of("exercise", language),
                kept,
                NOWHERE,
                source -> {},
                remark -> {},
                () -> {},
                onFailure);
    }

    public static void show(ResultPane pane, BackgroundWork work, Optional<Outcome> outcome) {
        show(pane, EXERCISE, work, outcome);
    }

    static void show(
            ResultPane pane, Exercise exercise, BackgroundWork work, Optional<Outcome> outcome) {
        pane.show(
                new ExerciseState(
                        exercise,
                        exercise.starter(),
                        List.of(),
                        outcome,
                        work,
                        Notice.NONE,
                        Notice.NONE,
                        Optional.empty(),
                        JoinAnswer.NONE),
                CaseResult.untried(exercise));
    }

    /** No points, every case judged alike. */
    public static Outcome outcome(GradingVerdict verdict) {
        return new Outcome(
                "",
                0,
                verdict.code(),
                new ScorePoints(0, 0, 0, 100),
                CaseResult.untried(EXERCISE).stream()
                        .map(one -> judged(one, verdict.code()))
                        .toList(),
                List.of(),
                LocalizedText.NOTHING,
                0,
                false);
    }

    /**
     * @param verdict its code, "" before there is one
     */
    static CaseResult judged(CaseResult one, String verdict) {
        return new CaseResult(
                one.name(), verdict, 0, one.of(), LocalizedText.NOTHING, List.of(), "");
    }

    /**
     * The component of that name, also where another part of the tab is in sight; null where there
     * is none.
     */
    public static Component named(Container within, String name) {
        for (Component each : within.getComponents()) {
            if (name.equals(each.getName())) return each;
            Component found = each instanceof Container inner ? named(inner, name) : null;
            if (found != null) return found;
        }
        return null;
    }
}
