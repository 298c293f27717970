package rasterlab.exercises.catalogue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.json.JsonFields;

/** Keeps what is wrong in a folder, so that reading goes on to what is wrong elsewhere. */
final class Faults {
    private final List<CatalogueException> found = new ArrayList<>();

    /** What is read; empty where it cannot be, which is kept. */
    <T> Optional<T> tried(Supplier<T> reading) {
        try {
            return Optional.of(reading.get());
        } catch (CatalogueException fault) {
            keep(fault);
            return Optional.empty();
        }
    }

    /** Keeps a fault, which may be found twice where a field is read twice. */
    void keep(CatalogueException fault) {
        if (found.stream().noneMatch(one -> one.said().equals(fault.said()))) found.add(fault);
    }

    void checked(Runnable check) {
        tried(
                () -> {
                    check.run();
                    return true;
                });
    }

    /** Keeps each field that is not among the known ones. */
    void checkKnown(JsonFields fields, String... known) {
        for (String one : fields.unknown(known)) keep(fields.refusal(one, known));
    }

    /** All, in the order in which they were found. */
    List<CatalogueException> all() {
        return List.copyOf(found);
    }

    void requireNone() {
        if (!found.isEmpty()) throw found.get(0);
    }
}
