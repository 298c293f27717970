package rasterlab.exercises.proving;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.PointPlan;
import rasterlab.exercises.runner.TimingCheck;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Phrase;

/**
 * The findings about an exercise.
 *
 * @param seed drew the generated cases
 * @param starter what the starter earns; empty where no judge was asked
 * @param model what the model solution earns; empty where there is none, or no judge was asked
 */
public record Proof(
        Exercise exercise,
        long seed,
        List<RightMethod> right,
        List<Kill> kills,
        Optional<SourcePoints> starter,
        Optional<SourcePoints> model) {
    /** The most points of 100 for the starter: more means that it does part of the work. */
    public static final int STARTER_AT_MOST = 10;

    /** The most points of 100 for a starter that is an input: any input shows some mistakes. */
    public static final int STARTING_INPUT_AT_MOST = 50;

    public Proof {
        right = List.copyOf(right);
        kills = List.copyOf(kills);
    }

    /** All that speaks against the exercise; nothing where it is proved. */
    public List<Phrase> faults() {
        List<Phrase> faults = new ArrayList<>();
        if (right.stream().noneMatch(RightMethod::isFull)) faults.add(Phrase.of("proof.no-right"));
        for (RightMethod one : right)
            if (one.errs())
                faults.add(Phrase.of("proof.right", one.name(), String.join(", ", one.failed())));
        for (RightMethod one : right)
            if (one.promised() && !one.breaking().isEmpty())
                faults.add(
                        Phrase.of("proof.breaks", one.name(), String.join(", ", one.breaking())));
        for (Kill one : kills) {
            if (one.asked() && !one.isRejected())
                faults.add(Phrase.of("proof.passes", one.mistake()));
            else if (one.asked() && !one.isNamed())
                faults.add(Phrase.of("proof.unnamed", one.mistake()));
            if (!one.asked() && one.isRejected() && one.isNamed() && isListed(one))
                faults.add(Phrase.of("proof.asked", one.mistake()));
        }
        int most =
                exercise.form() == Exercise.TaskKind.BREAK
                        ? STARTING_INPUT_AT_MOST
                        : STARTER_AT_MOST;
        starter.ifPresent(points -> addStarter(points, most, faults));
        model.ifPresent(points -> addModel(points, faults));
        return faults;
    }

    private boolean isListed(Kill one) {
        return exercise.evidence().notAsked().contains(one.mistake());
    }

    private void addStarter(SourcePoints starter, int most, List<Phrase> faults) {
        if (!starter.why().isEmpty())
            faults.add(
                    Phrase.of(
                            "proof.not-accepted",
                            "Starter." + exercise.form().ending(),
                            starter.why()));
        else if (starter.withoutSpeed() > most)
            faults.add(Phrase.of("proof.starter", starter.withoutSpeed(), most));
    }

    private void addModel(SourcePoints model, List<Phrase> faults) {
        PointPlan plan = exercise.points();
        if (!model.why().isEmpty())
            faults.add(Phrase.of("proof.not-accepted", "Model.java", model.why()));
        else if (model.points().accuracy() < plan.accuracy()
                || model.points().stability() < plan.stability())
            faults.add(
                    Phrase.of(
                            "proof.model",
                            model.points().accuracy(),
                            plan.accuracy(),
                            model.points().stability(),
                            plan.stability()));
        else if (plan.speed() > 0 && !model.untimed().isEmpty())
            faults.add(TimingCheck.at("exercise.json", untimed(model.untimed())));
    }

    /** The first sentence tells what stands in the way. */
    private static Phrase untimed(Message why) {
        Message first = new Message(why.sentences().subList(0, 1));
        return Phrase.of("proof.untimed", Phrase.of(first));
    }
}
