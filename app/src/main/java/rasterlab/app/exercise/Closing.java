package rasterlab.app.exercise;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.WholeFile;

/** Asks before a window closes with sources that are not on the disk. */
public final class Closing {
    private Closing() {}

    /** The decision on them. */
    public enum ClosingDecision {
        /** Each is written to a file that the user names. */
        SAVE_ELSEWHERE,
        /** The changes are lost. */
        CLOSE_ANYWAY,
        /** The window stays. */
        STAY
    }

    /** The person who is asked. */
    public interface User {
        /**
         * @param unsaved at least one
         */
        ClosingDecision answer(List<UnsavedDraft> unsaved);

        /** The file that the source is to be written to; empty when none is named. */
        Optional<Path> place(UnsavedDraft draft);

        /** Tells why a source could not be written there. */
        void tell(String problem);
    }

    /** Whether the window may close; asks again where a source could not be written. */
    public static boolean allowed(List<UnsavedDraft> unsaved, User user) {
        List<UnsavedDraft> left = unsaved;
        while (!left.isEmpty()) {
            switch (user.answer(left)) {
                case STAY -> {
                    return false;
                }
                case CLOSE_ANYWAY -> {
                    return true;
                }
                case SAVE_ELSEWHERE -> left = left.stream().filter(d -> !saved(d, user)).toList();
            }
        }
        return true;
    }

    private static boolean saved(UnsavedDraft draft, User user) {
        Optional<Path> file = user.place(draft);
        if (file.isEmpty()) return false;
        try {
            WholeFile.write(file.get(), draft.text().getBytes(StandardCharsets.UTF_8));
            return true;
        } catch (Complaint e) {
            user.tell(e.getMessage());
            return false;
        }
    }
}
