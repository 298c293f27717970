package rasterlab.app.study.chart;

import java.text.NumberFormat;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rasterlab.app.language.Texts;

/**
 * The names of workloads and their sizes. A workload's name without its numbers is its kind, such
 * as {@code side-corners} for {@code side-64-corners-20}. Words on a kind of one topic are the
 * topic's; those that topics share, the study's.
 *
 * @param texts of the study
 */
record WorkloadWords(Texts texts) {
    private static final Pattern NUMBER = Pattern.compile("-(\\d{1,9})(?=-|$)");

    /** A number of five digits or more, in which every third is set apart. */
    private static final Pattern LONG = Pattern.compile("\\d{5,}");

    /** The words for the input of methods; the name itself where it has none. */
    String workload(String topic, String name) {
        String said = workloadText("workload", topic, name);
        return said.equals(name) ? name : grouped(said);
    }

    private String grouped(String words) {
        NumberFormat groups = NumberFormat.getIntegerInstance(texts.locale());
        return LONG.matcher(words)
                .replaceAll(number -> groups.format(Long.parseLong(number.group())));
    }

    /** The size with what it counts, short enough to stand beside a point of a chart. */
    String size(String topic, String name, int size) {
        String said = workloadText("size", topic, name);
        return said.equals(name) ? LogTicks.size(size) : said;
    }

    private String workloadText(String what, String topic, String name) {
        String kind = NUMBER.matcher(name).replaceAll("");
        String key = what + "." + kind;
        Texts own = Texts.ofTopic(topic, texts.language());
        if (own.has(key)) return own.text(key, arguments(name));
        return texts.has(key) ? texts.text(key, arguments(name)) : name;
    }

    /** The numbers, for the form of words; then the same as they are written on a chart. */
    private static Object[] arguments(String name) {
        List<Integer> numbers =
                NUMBER.matcher(name)
                        .results()
                        .map(found -> Integer.valueOf(found.group(1)))
                        .toList();
        return Stream.concat(numbers.stream(), numbers.stream().map(LogTicks::size)).toArray();
    }
}
