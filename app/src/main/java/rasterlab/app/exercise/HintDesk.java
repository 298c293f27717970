package rasterlab.app.exercise;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.UUID;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.work.Background;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.server.Account;
import rasterlab.app.server.CourseServer;
import rasterlab.exercises.Exercise;

/**
 * Gives hints step by step: from the server, which records them, where a course was joined; else
 * from the exercise, and then nobody counts.
 */
public final class HintDesk implements AutoCloseable {
    private final CourseServer.ServerTimeouts patience;
    private final Background background;
    private final Runnable changed;

    /** Holds what a server has said, by server, token and exercise. */
    private final Map<String, HintView> told = new HashMap<>();

    /** Holds the key of each request until it is answered, so that none takes two steps. */
    private final Map<String, String> keys = new HashMap<>();

    private final Map<String, Integer> practised = new HashMap<>();
    private Notice notice = Notice.NONE;
    private boolean asking;

    /**
     * @param changed told on the thread of events that something is to be shown anew
     */
    HintDesk(
            CourseServer.ServerTimeouts patience,
            Executor events,
            Consumer<Throwable> onFailure,
            Runnable changed) {
        this.patience = patience;
        this.changed = changed;
        background = new Background("hints", events, onFailure);
    }

    HintView of(Exercise exercise, Optional<Account> account) {
        if (account.isEmpty())
            return HintView.practice(exercise, practised.getOrDefault(exercise.id(), 0));
        return told.getOrDefault(about(exercise, account.get()), HintView.unasked(exercise));
    }

    /** Why there is no hint; {@link Notice#NONE} where nothing went wrong. */
    public Notice notice() {
        return notice;
    }

    /** Whether a server is asked. */
    public boolean asking() {
        return asking;
    }

    /** Shows the next step, or first asks the server which ones were shown and what it costs. */
    void next(Exercise exercise, Optional<Account> account) {
        HintView view = of(exercise, account);
        if (asking || !view.more()) return;
        notice = Notice.NONE;
        if (account.isEmpty()) practised.merge(exercise.id(), 1, Integer::sum);
        else ask(exercise, account.get(), view);
        changed.run();
    }

    /** Forgets what went wrong, as when another exercise is shown. */
    void turnTo() {
        notice = Notice.NONE;
    }

    private void ask(Exercise exercise, Account account, HintView view) {
        String about = about(exercise, account);
        String path = "/api/v1/exercises/" + exercise.id() + "/hints";
        var server = new CourseServer(account.server(), patience);
        boolean takes = view.origin() == HintView.Origin.SERVER;
        String key = keys.computeIfAbsent(about, is -> UUID.randomUUID().toString());
        asking = true;
        background.begin(
                tell -> {
                    if (takes) server.post(path, account.token(), key);
                    JsonNode english = server.tree(server.get(path + "?lang=en", account.token()));
                    JsonNode russian = server.tree(server.get(path + "?lang=ru", account.token()));
                    HintView answer = view(english, russian);
                    return () -> {
                        if (takes) keys.remove(about);
                        told.put(about, answer);
                        changed.run();
                    };
                },
                () -> asking = false,
                failure -> {
                    notice = ServerNotices.hints(account.server(), failure);
                    changed.run();
                });
    }

    private static String about(Exercise exercise, Account account) {
        return account.server() + "\n" + account.token() + "\n" + exercise.id();
    }

    private static HintView view(JsonNode english, JsonNode russian) throws IOException {
        JsonNode taken = english.path("taken");
        if (!english.path("steps").isInt() || !taken.isArray())
            throw new IOException("the server's hints have no steps");
        List<LocalizedText> shown = new ArrayList<>();
        for (int i = 0; i < taken.size(); i++) {
            String text = taken.path(i).path("text").asText();
            shown.add(
                    new LocalizedText(
                            text, russian.path("taken").path(i).path("text").asText(text)));
        }
        JsonNode cost = english.path("next").path("cost");
        return new HintView(
                english.path("steps").intValue(),
                shown,
                cost.isInt() ? OptionalInt.of(cost.intValue()) : OptionalInt.empty(),
                HintView.Origin.SERVER);
    }

    @Override
    public void close() {
        background.close(() -> {});
    }
}
