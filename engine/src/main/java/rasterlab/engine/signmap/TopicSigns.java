package rasterlab.engine.signmap;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.predicate.PointQuestion;
import rasterlab.engine.predicate.Spacing;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** The sign maps of a topic's methods. */
final class TopicSigns<C, I, O> implements SignSubject {
    private final Topic<C, I, O> topic;
    private final PointQuestion<I, O> question;
    private final Map<Spacing, byte[]> exact = new EnumMap<>(Spacing.class);

    TopicSigns(Topic<C, I, O> topic, PointQuestion<I, O> question) {
        this.topic = topic;
        this.question = question;
    }

    @Override
    public String name() {
        return topic.name();
    }

    @Override
    public Optional<String> others() {
        return Optional.empty();
    }

    @Override
    public List<String> methods() {
        return topic.methods().stream().map(Method::name).toList();
    }

    @Override
    public SignMap map(String method) {
        C implementation = topic.method(method).implementation();
        Spacing spacing = question.spacing(method);
        var field =
                new SignField(
                        spacing, question.size(), question.left(spacing), question.low(spacing));
        byte[] answers =
                field.answers((x, y) -> answer(implementation, question.input(spacing, x, y)));
        return new SignMap(name(), method, true, field, answers, exact(field));
    }

    private synchronized byte[] exact(SignField field) {
        return exact.computeIfAbsent(
                field.spacing(),
                spacing -> field.answers((x, y) -> right(question.input(spacing, x, y))));
    }

    private int right(I input) {
        boolean yes = question.right(input).orElseGet(() -> question.yes(topic.exact(input, 1)));
        return yes ? 1 : 0;
    }

    private int sign(O output) {
        return question.yes(output) ? 1 : 0;
    }

    private int answer(C implementation, I input) {
        try {
            return sign(topic.run(implementation, input, Integer.MAX_VALUE));
        } catch (IllegalArgumentException | LimitReached refused) {
            return SignMap.NONE;
        }
    }
}
