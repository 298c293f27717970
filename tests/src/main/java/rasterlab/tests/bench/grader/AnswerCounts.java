package rasterlab.tests.bench.grader;

import java.net.http.HttpResponse;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Counts a server's answers by what they say. */
final class AnswerCounts {
    private static final int FAILED = 500;
    private static final int UNAVAILABLE = 503;
    private static final Pattern PROBLEM = Pattern.compile("urn:rasterlab:problem:([a-z-]+)");

    private final Map<String, Integer> counts = new LinkedHashMap<>();
    private final Map<String, Integer> unexcused = new LinkedHashMap<>();
    private final String silence;

    /**
     * @param silence the words for no answer at all
     */
    AnswerCounts(String silence) {
        this.silence = silence;
    }

    void add(HttpResponse<String> answer) {
        add(answer.statusCode(), answer.body(), answer.headers().firstValue("Retry-After"));
    }

    /**
     * @param retryAfter the header that says when to come again
     */
    void add(int status, String body, Optional<String> retryAfter) {
        Matcher problem = PROBLEM.matcher(body);
        String code = problem.find() ? " " + problem.group(1) : "";
        String again = retryAfter.map(seconds -> ", Retry-After " + seconds).orElse("");
        String kind = status + code + again;
        count(kind);
        boolean isExcused = status == UNAVAILABLE && retryAfter.isPresent();
        if (status >= FAILED && !isExcused) unexcused.merge(kind, 1, Integer::sum);
    }

    void addSilence() {
        count(silence);
    }

    private void count(String what) {
        counts.merge(what, 1, Integer::sum);
    }

    int total() {
        return counts.values().stream().mapToInt(Integer::intValue).sum();
    }

    /** Each kind of answer with how many there were, in the order in which they came first. */
    String text() {
        return text(counts);
    }

    /** Counts of the failures that do not ask to come again; empty where there was none. */
    String unexcusedText() {
        return text(unexcused);
    }

    private static String text(Map<String, Integer> counts) {
        return counts.entrySet().stream()
                .map(one -> one.getValue() + " × " + one.getKey())
                .collect(Collectors.joining("; "));
    }
}
