package rasterlab.app.cli.console;

import java.util.Arrays;
import java.util.List;

/** Names with commas between them, as options take them. */
public final class NameList {
    private NameList() {}

    /**
     * The names of an option in their order.
     *
     * @param given once for each time that the option was
     * @param known what the names may be, for the message
     * @throws IllegalArgumentException if a name between commas, or at an end, is empty
     */
    public static List<String> of(String option, List<String> given, List<String> known) {
        for (String names : given)
            if (Arrays.asList(names.split(",", -1)).contains(""))
                throw new IllegalArgumentException(
                        "%s '%s' has an empty name; expected some of %s with commas between them"
                                .formatted(option, names, String.join(", ", known)));
        return given.stream().flatMap(names -> Arrays.stream(names.split(","))).toList();
    }
}
