package rasterlab.exercises.judging;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise.Tolerance;
import rasterlab.exercises.TopicGrading.Call;
import rasterlab.exercises.TopicGrading.Caps;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/** One input of a topic and how an answer to it is judged. */
final class InputCall<C, I, O> implements Call {
    /** Characters of an input that is told as an example. */
    private static final int LONGEST_EXAMPLE = 160;

    private final ByTopic<C, I, O> grading;
    private final I input;
    private final Tolerance tolerance;
    private final boolean mayRefuse;

    InputCall(ByTopic<C, I, O> grading, I input, Tolerance tolerance, boolean mayRefuse) {
        this.grading = grading;
        this.input = input;
        this.tolerance = tolerance;
        this.mayRefuse = mayRefuse;
    }

    private Topic<C, I, O> topic() {
        return grading.topic();
    }

    @Override
    public Caps caps() {
        return Caps.ofItems(topic().mostBeforeEndless(items()));
    }

    /** None where the right method refuses the input. */
    @Override
    public long items() {
        try {
            return topic().spend(grading.right(), input);
        } catch (IllegalArgumentException refused) {
            return 0;
        }
    }

    @Override
    @SuppressWarnings("unchecked") // the caller has it from this grading's contract
    public Object recorded(Object method, int most) {
        return topic().record((C) method, input, most);
    }

    @Override
    public Finding judge(Answer answer) {
        return judged(answer, true);
    }

    @Override
    public Finding check(Answer answer) {
        return judged(answer, false);
    }

    @SuppressWarnings("unchecked") // recorded by this class
    private Finding judged(Answer answer, boolean whole) {
        if (answer.ending() != Answer.Ending.RETURNED || answer.output().isEmpty())
            return Failure.of(answer, mayRefuse);
        O exact = grading.exact(input);
        O actual = (O) answer.output().get();
        if (grading.isRight(input, exact, actual, tolerance)) return Finding.OK;
        List<List<Cause>> causes = new KnownMistakes<>(topic(), input).of(actual);
        if (!whole) return Finding.of(GradingVerdict.WRONG, Message.NONE, causes);
        Message said = said(exact, actual);
        // where several mistakes give this answer, none of them is told
        if (causes.size() == 1) said = said.and(causes.get(0).get(0).said());
        return new Finding(
                GradingVerdict.WRONG, said, grading.pictures(input, exact, actual), causes);
    }

    /** The first part of the answer that differs, and how far all of it is from right. */
    private Message said(O exact, O actual) {
        Leaves right = Leaves.of(topic().format(), input, exact);
        Leaves mine = Leaves.of(topic().format(), input, actual);
        Message said =
                right.firstUnlike(mine)
                        .map(place -> right.said(place, mine))
                        .orElse(Message.of("answer.differs"));
        Deviation deviation = topic().compare(input, exact, actual);
        String key = "answer.worst." + topic().errorUnit().replace(' ', '-');
        boolean measured = deviation.worst() > 0 && Double.isFinite(deviation.worst());
        return measured && Message.isKnown(key)
                ? said.and(Message.of(key, Leaves.number(deviation.worst())))
                : said;
    }

    @Override
    public boolean isRightWith(String mistake) {
        return new KnownMistakes<>(topic(), input).isRightWith(mistake, grading.exact(input));
    }

    /** None: a mistake of such a topic is not looked for by the kind of input. */
    @Override
    public Set<String> traits() {
        return Set.of();
    }

    @Override
    public Message example() {
        String json = Leaves.json(topic().format(), input);
        return json.length() > LONGEST_EXAMPLE ? Message.NONE : Message.of("answer.example", json);
    }

    /** The lab shows the input and a right answer, not yet what the student's method answered. */
    @Override
    public String scene(Optional<Answer> wrong) {
        return new MethodCase(
                        topic().name(),
                        rightMethod(),
                        Leaves.json(topic().format(), input),
                        Optional.empty())
                .write();
    }

    /** The first method that is right on this input; empty where all fail. */
    private Optional<String> rightMethod() {
        O exact = grading.exact(input);
        return topic().methods().stream()
                .filter(one -> !one.faulty())
                .filter(one -> isRight(one.implementation(), exact))
                .map(Method::name)
                .findFirst();
    }

    private boolean isRight(C method, O exact) {
        try {
            O output = topic().record(method, input, topic().mostItems());
            return topic().correct(topic().compare(input, exact, output));
        } catch (LimitReached | IllegalArgumentException refused) {
            return false;
        }
    }
}
