package rasterlab.exercises.score;

import java.util.List;

/**
 * A mistake that explains an answer by itself, such as a last pixel that is left out everywhere.
 *
 * @param code lower-case with hyphens; a group of cases may claim it
 * @param message the same for people
 */
public record Cause(String code, Message message) {
    /**
     * @param code of a text {@code mistake.CODE}
     * @param arguments what stands in its places
     */
    public static Cause of(String code, Object... arguments) {
        return new Cause(code, Message.of("mistake." + code, arguments));
    }

    public static List<String> codes(List<Cause> causes) {
        return causes.stream().map(Cause::code).toList();
    }
}
