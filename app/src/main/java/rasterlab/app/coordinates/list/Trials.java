package rasterlab.app.coordinates.list;

import java.util.List;
import java.util.Optional;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

/** The topics whose hazards are points of space. */
final class Trials {
    private final List<TrialKind<?, ?, ?>> kinds;

    /** The trials of somebody who has written no program. */
    Trials() {
        this(new OwnMethods());
    }

    Trials(OwnMethods own) {
        kinds = List.of(new ChainTrial(own), new TurnTrial(own), new LookTrial(own));
    }

    List<String> topics() {
        return kinds.stream().map(kind -> kind.topic().name()).toList();
    }

    /**
     * @throws IllegalArgumentException naming the topics there are
     */
    TrialKind<?, ?, ?> kind(String topic) {
        return Named.find("topic", topic, kinds, kind -> kind.topic().name());
    }

    List<? extends Method<?>> methods(String topic) {
        return kind(topic).topic().methods();
    }

    List<? extends Hazard<?>> hazards(String topic) {
        return kind(topic).topic().hazards();
    }

    Method<?> method(Trial trial) {
        return kind(trial.topic()).topic().method(trial.method());
    }

    Hazard<?> hazard(Trial trial) {
        return kind(trial.topic()).hazard(trial.hazard());
    }

    /** The topic's first hazard by its first method. */
    Trial first(String topic) {
        return new Trial(
                topic, hazards(topic).get(0).name(), kind(topic).topic().methods().get(0).name());
    }

    PointList list(Trial trial) {
        return kind(trial.topic()).list(trial.hazard());
    }

    TrialScene scene(Trial trial) {
        return kind(trial.topic()).scene(trial);
    }

    /** The shell command that has the method answer to the hazard. */
    String command(Trial trial) {
        return "echo '%s' | ./lab run %s %s"
                .formatted(
                        kind(trial.topic()).json(trial.hazard()),
                        trial.topic(),
                        OwnWords.known(trial.method(), "", trial.topic()));
    }

    /** The list as an input of the topic, in JSON; empty where it is none. */
    Optional<String> input(String topic, ListScene scene) {
        return kind(topic).input(scene);
    }

    /**
     * Passes for a choice without a trial, or with one of these and its points and matrices.
     *
     * @throws IllegalArgumentException naming what is not there or not the hazard's
     */
    void require(ListChoice choice) {
        for (Trial trial : choice.trial().stream().toList()) {
            method(trial);
            PointList list = list(trial);
            boolean same =
                    list.items().equals(choice.items()) && list.points().equals(choice.points());
            if (!same)
                throw new IllegalArgumentException(
                        "points and matrices must be those of hazard '%s' of topic '%s', got %s, %s"
                                .formatted(
                                        trial.hazard(),
                                        trial.topic(),
                                        choice.points(),
                                        choice.items()));
        }
    }
}
