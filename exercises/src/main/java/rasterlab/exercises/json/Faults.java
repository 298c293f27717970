package rasterlab.exercises.json;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.exercises.CatalogueException;

/** Keeps what is wrong in a document or a folder, so that reading goes on to what else is wrong. */
public final class Faults {
    private final List<CatalogueException> found = new ArrayList<>();

    /** The value that is read; empty where it cannot be, which is kept. */
    public <T> Optional<T> tried(Supplier<T> reading) {
        try {
            return Optional.of(reading.get());
        } catch (CatalogueException fault) {
            keep(fault);
            return Optional.empty();
        }
    }

    /** Keeps a fault, which may be found twice where a field is read twice. */
    public void keep(CatalogueException fault) {
        for (CatalogueException each : fault.all())
            if (found.stream().noneMatch(one -> one.phrase().equals(each.phrase())))
                found.add(each);
    }

    public void checked(Runnable check) {
        tried(
                () -> {
                    check.run();
                    return true;
                });
    }

    /** Keeps each field that is not among the known ones. */
    public void checkKnown(JsonFields fields, String... known) {
        for (String one : fields.unknown(known)) keep(fields.refusal(one, known));
    }

    /** All, in the order in which they were found. */
    public List<CatalogueException> all() {
        return List.copyOf(found);
    }

    /** Throws the first one. */
    public void requireNone() {
        if (!found.isEmpty()) throw found.get(0);
    }

    /** Throws all as one. */
    public void requireNoneOfAll() {
        if (!found.isEmpty()) throw CatalogueException.of(found);
    }
}
