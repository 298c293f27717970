package rasterlab.exercises.score;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * One judged case.
 *
 * @param name lower-case with hyphens; what mistake it catches
 * @param points earned, 0 to {@code of}; below 0 in the line that takes points off
 * @param explanation why points were lost, and of speed what was measured; else nothing
 * @param pictures of a wrong case whose answer can be drawn, each of another kind; else none
 * @param scene the case as a scene file (JSON) that the lab opens; empty where the case is hidden
 */
public record CaseReport(
        String name,
        Disclosure visibility,
        GradingVerdict verdict,
        int points,
        int of,
        Message explanation,
        List<CasePicture> pictures,
        String scene) {
    /** The name of a case whose own is kept from the student. */
    static final String HIDDEN = "hidden";

    /** The name of the line on speed, which is no case of the exercise. */
    public static final String SPEED = "speed";

    /** The name of the line that takes off what public cases do not pay. */
    private static final String WITHHELD = "withheld";

    private static final Pattern NUMBERED = Pattern.compile(HIDDEN + " (\\d+)");

    public CaseReport {
        if (points > of)
            throw new IllegalArgumentException(
                    "'%s' earned %d points of %d".formatted(name, points, of));
        pictures = List.copyOf(pictures);
        if (pictures.stream().map(CasePicture::kind).distinct().count() < pictures.size())
            throw new IllegalArgumentException("two pictures of '" + name + "' are of one kind");
    }

    /** Whether a case is called so because its own name is kept from the student. */
    public static boolean isHidden(String name) {
        return name.equals(HIDDEN);
    }

    /**
     * The line that takes points of public cases off, since most hidden inputs of their kind are
     * wrong: right on what everybody sees is no solution yet.
     *
     * @param points that are not paid
     * @param kinds of inputs, in English and in Russian
     */
    public static CaseReport withheld(int points, String kinds, String russianKinds) {
        return new CaseReport(
                WITHHELD,
                Disclosure.VERDICT_ONLY,
                GradingVerdict.WRONG,
                -points,
                0,
                Message.of("group.hidden", kinds, russianKinds),
                List.of(),
                "");
    }

    /** Whether the line called so is no case, but takes off what public cases do not pay. */
    public static boolean isWithheld(String name) {
        return name.equals(WITHHELD);
    }

    /** The case's points of those that can be earned there, or what is taken off alone. */
    public static String pointsOf(int points, int of) {
        return points < 0 ? "−" + -points : points + "/" + of;
    }

    /** Whether it is a case of the exercise, and no line on speed or on what is withheld. */
    boolean isOfExercise() {
        return !name.equals(SPEED) && !name.equals(WITHHELD);
    }

    /** Tells a case without a name of its own from others of the same result. */
    public static String hidden(int number) {
        return HIDDEN + " " + number;
    }

    /**
     * The text for a name that is the same in every exercise, in that language; empty for a case's
     * name.
     */
    public static Optional<String> ownTitle(String name, String language) {
        Matcher numbered = NUMBERED.matcher(name);
        if (numbered.matches())
            return Optional.of(Message.of("case.hidden.of", numbered.group(1)).in(language));
        return List.of(HIDDEN, SPEED, WITHHELD).contains(name)
                ? Optional.of(Message.of("case." + name).in(language))
                : Optional.empty();
    }

    /** Why points were lost, one line in English as JSON has it. */
    public String message() {
        return messageInJson("en");
    }

    /** The message in that language. */
    public String message(String language) {
        return VisibleText.line(explanation.in(language));
    }

    /** The message as JSON has it, see {@link Message#inJson}. */
    public String messageInJson(String language) {
        return VisibleText.line(explanation.inJson(language));
    }

    /** The place in the answer that is told, as a path of its JSON, if one is. */
    public Optional<String> place() {
        return explanation.place();
    }

    /** This report with what the student may not see taken out. */
    public CaseReport forStudent(boolean afterDeadline) {
        if (visibility == Disclosure.OPEN
                || name.equals(WITHHELD)
                || visibility == Disclosure.AFTER_DEADLINE && afterDeadline) return this;
        String shown = visibility == Disclosure.NEVER ? HIDDEN : name;
        return new CaseReport(shown, visibility, verdict, points, of, hint(), List.of(), "");
    }

    /** The class of the error; lines and other topics are wrong in words of their own. */
    private Message hint() {
        boolean any =
                explanation.sentences().stream().anyMatch(one -> one.key().startsWith("answer."));
        return any && verdict == GradingVerdict.WRONG
                ? Message.of("hidden.wrong.any")
                : verdict.hint();
    }
}
