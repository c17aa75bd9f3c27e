#include "hodt/io/svg_renderer.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/shared_library.h"

namespace hodt {

namespace {

// What of the C interfaces of librsvg, GLib and cairo is used, as their manuals have it: it is
// small and has been the same for years, while the headers would bring sixty packages to whoever
// builds.
struct GlibError {  // GError
  std::uint32_t domain;
  int code;
  char* message;
};
struct Rectangle {  // RsvgRectangle
  double x, y, width, height;
};
using Handle = void;             // RsvgHandle
using Surface = void;            // cairo_surface_t
using Context = void;            // cairo_t
constexpr int kRgb24 = 1;        // CAIRO_FORMAT_RGB24
constexpr int kSuccess = 0;      // CAIRO_STATUS_SUCCESS
constexpr int kWriteError = 11;  // CAIRO_STATUS_WRITE_ERROR
using Writer = int (*)(void* closure, const unsigned char* bytes, unsigned count);

struct Functions {
  Handle* (*rsvg_handle_new_from_data)(const std::uint8_t*, std::size_t, GlibError**);
  int (*rsvg_handle_render_document)(Handle*, Context*, const Rectangle*, GlibError**);
  void (*g_object_unref)(void*);
  void (*g_error_free)(GlibError*);
  Surface* (*cairo_image_surface_create)(int format, int width, int height);
  int (*cairo_surface_status)(Surface*);
  int (*cairo_surface_write_to_png_stream)(Surface*, Writer, void* closure);
  void (*cairo_surface_destroy)(Surface*);
  Context* (*cairo_create)(Surface*);
  int (*cairo_status)(Context*);
  void (*cairo_destroy)(Context*);
};

[[noreturn]] void refuse_to_load(const std::string& why) {
  throw ParameterError(fmt::format(
      "a picture as .png needs librsvg 2.46 or later, which cannot be loaded ({}); install it (on "
      "Debian: apt install librsvg2-2), or write .svg",
      why));
}

Functions load() {
  const SharedLibrary library({"librsvg-2.so.2"}, refuse_to_load);
  Functions functions{};
#define HODT_LOAD(name) library.find(#name, functions.name)
  HODT_LOAD(rsvg_handle_new_from_data);
  HODT_LOAD(rsvg_handle_render_document);
  HODT_LOAD(g_object_unref);
  HODT_LOAD(g_error_free);
  HODT_LOAD(cairo_image_surface_create);
  HODT_LOAD(cairo_surface_status);
  HODT_LOAD(cairo_surface_write_to_png_stream);
  HODT_LOAD(cairo_surface_destroy);
  HODT_LOAD(cairo_create);
  HODT_LOAD(cairo_status);
  HODT_LOAD(cairo_destroy);
#undef HODT_LOAD
  return functions;
}

const Functions& rsvg() {
  static const Functions functions = load();
  return functions;
}

[[noreturn]] void refuse_to_draw(GlibError* error) {
  const std::string why = error ? error->message : "no memory";
  if (error) rsvg().g_error_free(error);
  throw ParameterError("librsvg cannot draw the picture (" + why + "); write .svg");
}

int append(void* closure, const unsigned char* bytes, unsigned count) {
  try {
    static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(bytes), count);
    return kSuccess;
  } catch (...) {  // nothing may be thrown through a library in C
    return kWriteError;
  }
}

}  // namespace

void require_svg_renderer() {
  rsvg();
}

std::string png_of_svg(const std::string& svg, double width, double height, double scale) {
  const Functions& f = rsvg();
  const double columns = std::round(width * scale), rows = std::round(height * scale);
  const std::unique_ptr<Surface, void (*)(Surface*)> surface(
      f.cairo_image_surface_create(kRgb24, static_cast<int>(columns), static_cast<int>(rows)),
      f.cairo_surface_destroy);
  if (f.cairo_surface_status(surface.get()) != kSuccess) refuse_to_draw(nullptr);
  GlibError* error = nullptr;
  const std::unique_ptr<Handle, void (*)(void*)> handle(
      f.rsvg_handle_new_from_data(reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size(),
                                  &error),
      f.g_object_unref);
  if (!handle) refuse_to_draw(error);
  {
    const std::unique_ptr<Context, void (*)(Context*)> context(f.cairo_create(surface.get()),
                                                               f.cairo_destroy);
    const Rectangle page{0, 0, columns, rows};
    if (!f.rsvg_handle_render_document(handle.get(), context.get(), &page, &error) ||
        f.cairo_status(context.get()) != kSuccess)
      refuse_to_draw(error);
  }
  std::string png;
  if (f.cairo_surface_write_to_png_stream(surface.get(), append, &png) != kSuccess)
    refuse_to_draw(nullptr);
  return png;
}

}  // namespace hodt
