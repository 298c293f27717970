package rasterlab.exercises.judging;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Message.Sentence;

/** Puts what is told of a broken property into few words: what does not fit in is left out. */
final class BriefMessage {
    /** Words, in the language that needs more. */
    static final int MOST = 60;

    private BriefMessage() {}

    /**
     * The message.
     *
     * @param broken says which property, and on which input
     * @param unfit what does not fit there, left out where the mistake's name needs its place
     * @param rule that the property assumes
     * @param which says which answer is wrong
     * @param wrong what is told of that answer alone: the mistake that explains it comes last, and
     *     in its short form where the long one does not fit in
     */
    static Message of(Message broken, Message unfit, Message rule, Message which, Message wrong) {
        Message mistakes = only(wrong, true);
        Message whole = broken.and(unfit).and(rule);
        Message least = broken.and(rule).and(brief(mistakes));
        return Stream.of(
                        whole.and(which).and(only(wrong, false)).and(mistakes),
                        whole.and(which).and(mistakes),
                        whole.and(mistakes),
                        whole.and(brief(mistakes)),
                        least)
                .filter(BriefMessage::fits)
                .findFirst()
                .orElse(least);
    }

    private static Message only(Message said, boolean mistakes) {
        return new Message(
                said.sentences().stream().filter(one -> isOnAMistake(one) == mistakes).toList());
    }

    private static boolean isOnAMistake(Sentence one) {
        return one.key().startsWith("known-") || one.key().startsWith("mistake.");
    }

    /** Keeps the first fault of a faulty method in place of all. */
    private static Message brief(Message mistakes) {
        return new Message(
                mistakes.sentences().stream()
                        .map(
                                one ->
                                        new Sentence(
                                                one.key(),
                                                one.arguments().stream()
                                                        .map(BriefMessage::firstFault)
                                                        .toList()))
                        .toList());
    }

    private static String firstFault(String argument) {
        return argument.startsWith("faults.") ? argument.replaceFirst("s", "") : argument;
    }

    private static boolean fits(Message said) {
        return Stream.of("en", "ru")
                .allMatch(language -> List.of(said.in(language).split("\\s+")).size() <= MOST);
    }
}
