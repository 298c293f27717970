package rasterlab.exercises.runner;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.ClassFiles;
import rasterlab.exercises.runner.scan.AllowList;
import rasterlab.exercises.runner.scan.ByteCodeCheck;
import rasterlab.exercises.score.GradingVerdict;

/**
 * The right methods that a student's speed is held against: a topic's own, or the exercise's model
 * solution, which is compiled once.
 */
final class Models {
    private static final System.Logger LOG = System.getLogger(Models.class.getName());

    private final Map<String, Optional<Model>> compiled = new ConcurrentHashMap<>();
    private final Map<String, Object> instances = new ConcurrentHashMap<>();
    private final Classics classics = new Classics();

    /**
     * A compiled class.
     *
     * @param entry name of the one that implements the contract
     * @param classes binary name to class file
     */
    record Model(String entry, Map<String, byte[]> classes) {}

    /** The topic's methods to show beside a student's. */
    Classics classics() {
        return classics;
    }

    /** The exercise's; empty where it is none, which is no fault of a student's. */
    Optional<Model> of(
            Exercise exercise, TopicGrading topic, Children children, JudgeSettings settings)
            throws ChildLost, InterruptedException {
        if (exercise.evidence().model().isEmpty()) return topic.reference().map(Models::own);
        String source = exercise.evidence().model().get();
        Optional<Model> known = compiled.get(source);
        if (known != null) return known;
        Optional<Model> made = compiled(exercise.id(), source, topic, children, settings);
        compiled.put(source, made);
        return made;
    }

    /**
     * A method of that model in this process, the same one each time, so that Java knows it after a
     * while.
     */
    Object instance(Exercise exercise, TopicGrading topic, Model model) {
        return exercise.evidence()
                .model()
                .map(
                        source ->
                                instances.computeIfAbsent(
                                        source,
                                        made ->
                                                OwnLoader.instance(
                                                        model.entry(),
                                                        model.classes(),
                                                        topic.contract())))
                .orElseGet(topic::right);
    }

    private static Model own(Class<?> method) {
        String own = method.getPackageName().replace('.', '/') + '/';
        Map<String, byte[]> classes = new LinkedHashMap<>();
        ClassFiles.closure(method, own)
                .forEach(
                        (resource, bytes) ->
                                classes.put(
                                        resource.replace(".class", "").replace('/', '.'), bytes));
        return new Model(method.getName(), classes);
    }

    private static Optional<Model> compiled(
            String id, String source, TopicGrading topic, Children children, JudgeSettings settings)
            throws ChildLost, InterruptedException {
        Compilation result =
                Compiling.inAChild(
                        children, source, settings.patience().limit(settings.compileLimit()));
        if (result.verdict() != GradingVerdict.OK) return unusable(id, result.errors());
        ByteCodeCheck.Result checked =
                new ByteCodeCheck(AllowList.of(topic.contract()))
                        .check(
                                result.classes(),
                                topic.contract().getName().replace('.', '/'),
                                source);
        return checked.refusals().isEmpty()
                ? Optional.of(new Model(checked.entry(), result.classes()))
                : unusable(id, checked.refusals());
    }

    private static Optional<Model> unusable(String id, Object why) {
        LOG.log(
                System.Logger.Level.WARNING,
                "no speed is measured on {0}: its model solution is not accepted, {1}",
                id,
                why);
        return Optional.empty();
    }
}
