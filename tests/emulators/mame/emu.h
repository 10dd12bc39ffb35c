/* SPDX-License-Identifier: MIT */
/* What the glue uses of MAME, written for the tests: devices, an I/O space of 16 bits, bitmaps and
 * save items under MAME's names. */
#ifndef SUPERFRAME_TESTS_MAME_EMU_H
#define SUPERFRAME_TESTS_MAME_EMU_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

typedef uint8_t u8;
typedef uint16_t u16;
typedef uint32_t u32;
typedef unsigned offs_t;

#define FUNC(name)        &name
#define NAME(item)        item, #item
#define DEVICE_SELF_OWNER "^"

class device_t;
struct machine_config {};
struct device_type {
    const char *name;
};
#define DECLARE_DEVICE_TYPE(type, class)            extern const device_type type;
#define DEFINE_DEVICE_TYPE(type, class, name, text) const device_type type = {name};

class emu_fatalerror : public std::runtime_error {
  public:
    emu_fatalerror(const char *format, const char *text)
        : std::runtime_error(std::string(format) + text) {}
};

typedef std::function<u16(offs_t, u16)> read16s;
typedef std::function<void(offs_t, u16, u16)> write16s;

/* Binds a member function to its device. */
template <class Device>
read16s read16s_delegate(Device &device, u16 (Device::*function)(offs_t, u16)) {
    return
        [&device, function](offs_t offset, u16 mask) { return (device.*function)(offset, mask); };
}
template <class Device>
write16s write16s_delegate(Device &device, void (Device::*function)(offs_t, u16, u16)) {
    return [&device, function](offs_t offset, u16 data, u16 mask) {
        (device.*function)(offset, data, mask);
    };
}

/* An I/O space as a CPU of 16 bits sees it. */
struct address_space {
    offs_t start = 1, end = 0;
    read16s reader;
    write16s writer;

    void install_readwrite_handler(offs_t first, offs_t last, read16s read, write16s write) {
        start = first;
        end = last;
        reader = read;
        writer = write;
    }
};

class device_t {
  public:
    device_t(const machine_config &, const device_type &, const char *, device_t *, u32) {}
    virtual ~device_t() {}
    void start() {
        device_start();
    }
    void reset() {
        device_reset();
    }
    std::vector<u8> save() {
        device_pre_save();
        return std::vector<u8>(item, item + size);
    }
    void load(const std::vector<u8> &bytes) {
        std::copy(bytes.begin(), bytes.end(), item);
        device_post_load();
    }

  protected:
    virtual void device_start() = 0;
    virtual void device_reset() {}
    virtual void device_pre_save() {}
    virtual void device_post_load() {}
    template <size_t Size> void save_item(u8 (&bytes)[Size], const char *) {
        item = bytes;
        size = Size;
    }

  private:
    u8 *item = nullptr;
    size_t size = 0;
};

/* The one device of its kind that the test's machine has. */
template <class Device> struct the_only { static Device *device; };
template <class Device> Device *the_only<Device>::device = nullptr;

template <class Device> struct device_finder {
    device_finder(device_t &, const char *) {}
    Device *operator->() const {
        return the_only<Device>::device;
    }
    explicit operator bool() const {
        return the_only<Device>::device != nullptr;
    }
};
template <class Device> using required_device = device_finder<Device>;
template <class Device> using optional_device = device_finder<Device>;

struct rectangle {
    int min_x, max_x, min_y, max_y;
    int left() const {
        return min_x;
    }
    int right() const {
        return max_x;
    }
    int top() const {
        return min_y;
    }
    int bottom() const {
        return max_y;
    }
};

struct bitmap_rgb32 {
    std::vector<u32> pixels;
    u32 &pix(int y, int x) {
        return pixels.at(size_t(y) * 640 + size_t(x));
    }
};

#endif
