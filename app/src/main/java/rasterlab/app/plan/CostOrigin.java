package rasterlab.app.plan;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.app.language.Texts;

/** Says where the predicted costs come from. */
public final class CostOrigin {
    private static final Pattern FITTED =
            Pattern.compile(
                    "non-negative least squares on (\\d+) pictures: (\\d+) scenes, (\\d+) sizes,"
                            + " (\\d+) shadings, (\\d+) methods, least of (\\d+) rounds; (.*)");

    private CostOrigin() {}

    /**
     * The origin of a table of costs in a language.
     *
     * @param origin in English; what is told in another way stays as it is
     */
    public static String translated(Texts texts, String origin) {
        Matcher parts = FITTED.matcher(origin);
        if (!parts.matches()) return origin;
        var numbers = new Object[7];
        for (int i = 0; i < numbers.length; i++) numbers[i] = parts.group(i + 1);
        numbers[6] =
                parts.group(7)
                        .replace("this machine, now", texts.text("costs.here"))
                        .replaceAll("(\\d+) cores", texts.text("costs.cores", "$1"));
        return texts.text("costs.fitted", numbers);
    }
}
