package rasterlab.app.server;

import java.io.IOException;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.net.http.HttpTimeoutException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Flow;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** Server-sent events as they come, read by one thread. */
final class EventLines implements AutoCloseable {
    /**
     * @param type such as "case"
     * @param data JSON
     */
    record Event(String type, String data) {}

    private static final String END = "\0end";

    private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
    private final Duration quiet;
    private final Receiver receiver = new Receiver();
    private CompletableFuture<HttpResponse<Void>> response;

    private EventLines(Duration quiet) {
        this.quiet = quiet;
    }

    /**
     * @param quiet the longest time without a line
     */
    static EventLines open(HttpClient http, HttpRequest request, Duration quiet) {
        var events = new EventLines(quiet);
        events.response =
                http.sendAsync(
                        request,
                        answer ->
                                answer.statusCode() == 200
                                        ? BodyHandlers.fromLineSubscriber(events.receiver)
                                                .apply(answer)
                                        : HttpResponse.BodySubscribers.replacing(null));
        events.response.whenComplete(
                (answer, broken) -> {
                    if (broken != null || answer.statusCode() != 200) events.lines.add(END);
                });
        return events;
    }

    /**
     * The next event; empty where the server has ended them.
     *
     * @throws HttpTimeoutException after too long a silence
     */
    Optional<Event> next() throws IOException, InterruptedException {
        String type = "message";
        var data = new StringBuilder();
        while (true) {
            String line = line();
            if (line == END) return Optional.empty();
            if (line.isEmpty() && !data.isEmpty())
                return Optional.of(new Event(type, data.toString()));
            if (line.startsWith("event:")) type = line.substring("event:".length()).strip();
            if (line.startsWith("data:")) data.append(line.substring("data:".length()).strip());
        }
    }

    private String line() throws IOException, InterruptedException {
        String line = lines.poll(quiet.toMillis(), TimeUnit.MILLISECONDS);
        if (line == null)
            throw new HttpTimeoutException("no event within " + quiet.toSeconds() + " s");
        if (line == END) ended();
        return line;
    }

    /** Passes where the events ended of themselves. */
    private void ended() throws IOException, InterruptedException {
        try {
            int status = response.get(quiet.toMillis(), TimeUnit.MILLISECONDS).statusCode();
            if (status != 200) throw new ServerRefusal(status, "", "status " + status);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof IOException cause) throw cause;
            throw new IOException(e.getCause());
        } catch (TimeoutException e) {
            throw new HttpTimeoutException("no end of the events within " + quiet.toSeconds());
        }
    }

    @Override
    public void close() {
        receiver.cancel();
        response.cancel(true);
    }

    private final class Receiver implements Flow.Subscriber<String> {
        private volatile Flow.Subscription subscription;

        @Override
        public void onSubscribe(Flow.Subscription given) {
            subscription = given;
            given.request(Long.MAX_VALUE);
        }

        @Override
        public void onNext(String line) {
            lines.add(line);
        }

        @Override
        public void onError(Throwable broken) {
            lines.add(END);
        }

        @Override
        public void onComplete() {
            lines.add(END);
        }

        private void cancel() {
            Flow.Subscription given = subscription;
            if (given != null) given.cancel();
        }
    }
}
