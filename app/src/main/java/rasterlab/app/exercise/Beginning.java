package rasterlab.app.exercise;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import rasterlab.app.canvas.Background;
import rasterlab.app.server.Account;
import rasterlab.app.server.CourseServer;
import rasterlab.app.server.CourseServer.Patience;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Form;
import rasterlab.exercises.predicting.SheetText;

/**
 * The text that an exercise is begun with: its own, or a sheet of questions, which is the server's
 * where there is an account.
 */
record Beginning(Exercise exercise, Optional<Account> account, Patience patience) {
    /** The text that needs no server; of a sheet another one at each call. */
    static String here(Exercise exercise) {
        return exercise.form() == Form.PREDICT
                ? SheetText.open(exercise, SheetText.freshSeed())
                : exercise.starter();
    }

    /**
     * Gives the text at once, or what asks the server for it.
     *
     * @param begin takes what is to be done, and who is told why it failed
     */
    void give(
            Consumer<String> take,
            Consumer<Notice> tell,
            BiConsumer<Background.Task, Consumer<IOException>> begin) {
        if (exercise.form() != Form.PREDICT || account.isEmpty()) take.accept(here(exercise));
        else begin.accept(asked(take), refused(tell));
    }

    /** Asks the server for the sheet of the next attempt. */
    private Background.Task asked(Consumer<String> take) {
        Account holder = account.orElseThrow();
        return tell -> {
            byte[] sheet =
                    new CourseServer(holder.server(), patience)
                            .get("/api/v1/exercises/" + exercise.id() + "/starter", holder.token());
            String text = new String(sheet, StandardCharsets.UTF_8);
            return () -> take.accept(text);
        };
    }

    /** Tells why the server did not give it. */
    private Consumer<IOException> refused(Consumer<Notice> tell) {
        return failure -> tell.accept(ServerNotices.of(account.orElseThrow().server(), failure));
    }
}
